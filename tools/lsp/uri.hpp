#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rt::tools::lsp {

/// "file:///tmp/a%20b.rtl" of an absolute path (RFC 8089).
std::string file_uri(const std::filesystem::path& path);

/// The path that a URI names; nothing where it names no file of this machine, as "untitled:Untitled-1" does.
std::optional<std::filesystem::path> file_path(std::string_view uri);

} // namespace rt::tools::lsp
