#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rt::lang {

/// The set of types that a parameter of a built-in function accepts.
enum class ArgumentType : std::uint16_t {
  number = 1,
  boolean = 2,
  string = 4,
  vector = 8, ///< three numbers
  point = 16, ///< two or three numbers
  color = 32,
  list = 64, ///< a list, vector or range
  function = 128,
  any = 256,
};

struct SignatureParameter {
  std::string_view name;
  unsigned types = 0;
  std::string_view types_text;   ///< "number or vector"
  std::string_view default_text; ///< empty if it must be given, unless `is_optional`
  bool is_optional = false;
  bool is_rest = false; ///< takes all further arguments
  constexpr bool takes(ArgumentType type) const { return (types & static_cast<unsigned>(type)) != 0; }
};

/// The parameters of a built-in function, parsed at compile time from a text such as `x: number or vector, low: number
/// = 0, keys…: any`. A default of `?` means that the parameter may be omitted.
class Signature {
public:
  static constexpr std::size_t most = 8;

  consteval Signature(const char* source) : text_(source) {
    std::string_view rest = text_;
    while (!rest.empty()) {
      const std::size_t comma = outer_comma(rest);
      if (count_ == most) throw "too many parameters";
      parameters_[count_++] = parameter(rest.substr(0, comma));
      rest = comma == rest.size() ? std::string_view{} : rest.substr(comma + 2);
    }
  }

  constexpr std::string_view text() const { return text_; }
  constexpr std::size_t size() const { return count_; }
  constexpr const SignatureParameter& operator[](std::size_t i) const { return parameters_[i]; }
  constexpr const SignatureParameter* begin() const { return parameters_.data(); }
  constexpr const SignatureParameter* end() const { return parameters_.data() + count_; }
  constexpr bool has_rest() const { return count_ > 0 && parameters_[count_ - 1].is_rest; }

private:
  static constexpr std::size_t find(std::string_view text, std::string_view what) {
    const std::size_t at = text.find(what);
    return at == std::string_view::npos ? text.size() : at;
  }

  static constexpr std::size_t outer_comma(std::string_view text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      depth += text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
      if (depth == 0 && text[i] == ',') return i;
    }
    return text.size();
  }

  static consteval unsigned type(std::string_view word) {
    constexpr std::string_view words[] = {"number", "boolean", "string",   "vector", "point",
                                          "color",  "list",    "function", "any"};
    for (std::size_t i = 0; i < std::size(words); ++i) {
      if (words[i] == word) return 1U << i;
    }
    throw "not a type";
  }

  static consteval SignatureParameter parameter(std::string_view text) {
    SignatureParameter p;
    const std::size_t equals = find(text, " = ");
    if (equals < text.size()) {
      p.is_optional = true;
      p.default_text = text.substr(equals + 3);
      if (p.default_text == "?") p.default_text = {};
      text = text.substr(0, equals);
    }
    const std::size_t colon = find(text, ": ");
    if (colon == text.size()) throw "a parameter without a type";
    p.name = text.substr(0, colon);
    constexpr std::string_view dots = "…";
    if (p.name.ends_with(dots)) p.is_rest = true, p.name.remove_suffix(dots.size());
    p.types_text = text.substr(colon + 2);
    for (std::string_view words = p.types_text; !words.empty();) {
      const std::size_t end = find(words, " or ");
      p.types |= type(words.substr(0, end));
      words = end == words.size() ? std::string_view{} : words.substr(end + 4);
    }
    return p;
  }

  std::string_view text_;
  std::array<SignatureParameter, most> parameters_{};
  std::size_t count_ = 0;
};

} // namespace rt::lang
