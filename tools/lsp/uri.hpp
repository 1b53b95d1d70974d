#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rt::tools::lsp {

/// "file:///tmp/a%20b.rtl" for an absolute path (RFC 8089).
std::string file_uri(const std::filesystem::path& path);

/// The path that a URI names; nothing if it is not a file on this machine, such as "untitled:Untitled-1".
std::optional<std::filesystem::path> file_path(std::string_view uri);

} // namespace rt::tools::lsp
