#include "tools/lsp/uri.hpp"

#include "lang/text/characters.hpp"

#include <fmt/format.h>

#include <charconv>

namespace rt::tools::lsp {
namespace {

// RFC 3986, section 2.3, and the slash.
bool stands_for_itself(char c) {
  return lang::is_name_part(c) || c == '-' || c == '.' || c == '~' || c == '/';
}

} // namespace

std::string file_uri(const std::filesystem::path& path) {
  std::string uri = "file://";
  for (const char c : path.string())
    uri += stands_for_itself(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return uri;
}

std::optional<std::filesystem::path> file_path(std::string_view uri) {
  constexpr std::string_view scheme = "file://";
  if (!uri.starts_with(scheme)) return std::nullopt;
  uri.remove_prefix(scheme.size());
  if (uri.starts_with("localhost/")) uri.remove_prefix(std::string_view("localhost").size());
  if (!uri.starts_with('/')) return std::nullopt;
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    if (uri[i] == '%' && i + 2 < uri.size() && lang::is_hex_digit(uri[i + 1]) && lang::is_hex_digit(uri[i + 2])) {
      std::from_chars(uri.data() + i + 1, uri.data() + i + 3, value, 16);
      path += static_cast<char>(value);
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path;
}

} // namespace rt::tools::lsp
