#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace rt::tools::lsp {

/// Reads messages as the base protocol frames them: header lines, of which Content-Length counts, an empty line, and so
/// many bytes.
class MessageReader {
public:
  /// `is_over` is asked now and then while nothing comes.
  MessageReader(int file, std::function<bool()> is_over) : file_(file), is_over_(std::move(is_over)) {}

  /// The next message's bytes, or nothing at the end of the input, be it in the middle of a message. Empty for a header
  /// that does not say how long the message is; what follows is searched for the next one that does.
  std::optional<std::string> next();

private:
  std::optional<std::string> line();
  bool read_more();

  int file_;
  std::function<bool()> is_over_;
  std::string buffer_; // what was read and not yet given
  bool is_lost_ = false;
};

/// A message with its header. What is no UTF-8 in it becomes U+FFFD.
std::string framed(const nlohmann::json& message);

} // namespace rt::tools::lsp
