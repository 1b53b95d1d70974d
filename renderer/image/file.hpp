#pragma once

#include <string>
#include <string_view>

namespace rt {

/// Reads a whole file. Throws std::system_error, which names the path.
std::string read_file(const std::string& path);

/// Replaces a file's content with `bytes` atomically: they go to a temporary file beside it, which is then renamed. On
/// failure an existing file stays as it was, nothing new is left behind, and a std::system_error names the path. A
/// symbolic link is followed; if `is_stream`, the path is written to directly.
void replace_file(const std::string& path, std::string_view bytes);

/// Whether the path names something that is written to sequentially and not replaced: a pipe, a device, or a descriptor
/// of the process (/dev/stdout).
bool is_stream(const std::string& path);

/// Throws what `replace_file` would throw if the folder is missing or not writable, without writing anything.
void require_writable(const std::string& path);

/// Writes all bytes to an open file. Throws std::system_error, which names it as `name`.
void write_all(int file, std::string_view bytes, const std::string& name);

} // namespace rt
