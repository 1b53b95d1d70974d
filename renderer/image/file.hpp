#pragma once

#include <string>
#include <string_view>

namespace rt {

/// The whole of a file. Throws std::system_error, which names the path.
std::string read_file(const std::string& path);

/// Makes `bytes` the content of a file, whole or not at all: they go to a temporary file beside it, which is then
/// renamed. On failure an old file stays as it was, nothing new is left behind, and a std::system_error names the path.
/// A symbolic link is followed; what `is_stream` is written to directly.
void replace_file(const std::string& path, std::string_view bytes);

/// Whether there is something at the path that takes bytes one after the other and is not replaced: a pipe, a device,
/// or a descriptor of the process by its name (/dev/stdout).
bool is_stream(const std::string& path);

/// Throws what `replace_file` would throw for a folder that is missing or may not be written, without writing anything.
void require_writable(const std::string& path);

/// Writes all bytes to an open file. Throws std::system_error, which names it as `name`.
void write_all(int file, std::string_view bytes, const std::string& name);

} // namespace rt
