#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace rt::tools::lsp {

/// Reads messages as framed by the base protocol: header lines, of which Content-Length counts, an empty line, and that
/// many bytes.
class MessageReader {
public:
  /// `is_over` is polled while nothing arrives.
  MessageReader(int file, std::function<bool()> is_over) : file_(file), is_over_(std::move(is_over)) {}

  /// The next message's bytes, or nothing at the end of the input, even in the middle of a message. Empty for a header
  /// without a valid length; the following input is searched for the next valid one.
  std::optional<std::string> next();

private:
  std::optional<std::string> line();
  bool read_more();

  int file_;
  std::function<bool()> is_over_;
  std::string buffer_; // read but not yet returned
  bool is_lost_ = false;
};

/// A message with its header. Invalid UTF-8 in it becomes U+FFFD.
std::string framed(const nlohmann::json& message);

} // namespace rt::tools::lsp
