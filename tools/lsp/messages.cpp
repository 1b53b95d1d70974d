#include "tools/lsp/messages.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <string_view>

namespace rt::tools::lsp {
namespace {

constexpr std::size_t longest_message = std::size_t{1} << 28;
constexpr std::size_t longest_header = std::size_t{1} << 16;
constexpr int pause = 200; // milliseconds between two polls of `is_over_`

// The number after "Content-Length:", in any case, at the start of the line or anywhere in it. Nothing if there is
// none, or it is not a valid length.
std::optional<std::size_t> content_length(std::string_view line, bool anywhere) {
  constexpr std::string_view name = "content-length:";
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  const auto found =
      std::search(line.begin(), line.end(), name.begin(), name.end(), [&](char a, char b) { return lower(a) == b; });
  if (found == line.end() || (found != line.begin() && !anywhere)) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(found - line.begin()) + name.size());
  while (line.starts_with(' ')) line.remove_prefix(1);
  while (line.ends_with(' ') || line.ends_with('\r')) line.remove_suffix(1);
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), length);
  if (error != std::errc() || end != line.data() + line.size() || length > longest_message) return std::nullopt;
  return length;
}

} // namespace

bool MessageReader::read_more() {
  while (true) {
    pollfd wanted{file_, POLLIN, 0};
    const int ready = ::poll(&wanted, 1, pause);
    if (ready == 0 && is_over_()) return false;
    if (ready < 0 && errno != EINTR) return false;
    if (ready <= 0) continue;
    std::array<char, 1 << 16> bytes;
    const ssize_t count = ::read(file_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    buffer_.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }
}

std::optional<std::string> MessageReader::line() {
  std::size_t searched = 0;
  while (true) {
    const std::size_t end = buffer_.find('\n', searched);
    if (end != std::string::npos) {
      std::string found = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return found;
    }
    if (buffer_.size() > longest_header) { // not a header: its end may be the beginning of the next one
      is_lost_ = true;
      buffer_.erase(0, buffer_.size() - 64);
    }
    searched = buffer_.size();
    if (!read_more()) return std::nullopt;
  }
}

std::optional<std::string> MessageReader::next() {
  std::optional<std::size_t> length;
  while (true) {
    const std::optional<std::string> header = line();
    if (!header) return std::nullopt;
    if (header->empty() || *header == "\r") break;
    if (const auto found = content_length(*header, is_lost_)) length = found;
  }
  if (!length) {
    is_lost_ = true;
    return std::string();
  }
  is_lost_ = false;
  while (buffer_.size() < *length)
    if (!read_more()) return std::nullopt;
  std::string message = buffer_.substr(0, *length);
  buffer_.erase(0, *length);
  return message;
}

std::string framed(const nlohmann::json& message) {
  const std::string text = message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return fmt::format("Content-Length: {}\r\n\r\n{}", text.size(), text);
}

} // namespace rt::tools::lsp
