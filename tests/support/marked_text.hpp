#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tests {

/// A text with places in it, each marked by `‸`.
struct MarkedText {
  std::string text;                  ///< without the marks
  std::vector<std::uint32_t> places; ///< byte offsets

  explicit MarkedText(std::string_view marked) {
    constexpr std::string_view mark = "‸";
    for (std::size_t at; (at = marked.find(mark)) != std::string_view::npos; marked.remove_prefix(at + mark.size())) {
      text += marked.substr(0, at);
      places.push_back(static_cast<std::uint32_t>(text.size()));
    }
    text += marked;
  }
};

} // namespace rt::tests
