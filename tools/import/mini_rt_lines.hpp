#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "renderer/math/vec3.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The lines of a miniRT file: an element's identifier and its fields.
namespace rt::tools::import::mini_rt {

/// The kind of a field.
enum class FieldKind : std::uint8_t {
  ratio,     ///< 0 to 1
  length,    ///< above 0
  angle,     ///< 0 to 180
  pixels,    ///< an integer above 0
  point,     ///< three numbers
  direction, ///< three numbers from −1 to 1, not all 0
  color,     ///< three integers from 0 to 255
};

struct FieldRow {
  FieldKind kind;
  std::string_view name; ///< "diameter"
};

enum class Word : std::uint8_t { R, A, C, c, L, l, sp, pl, cy, sq, tr, co, di };

/// Which of the two versions of the format an element is in.
enum class Forms : std::uint8_t { both, older, newer, neither };

struct ElementRow {
  Word word;
  std::string_view spelling;
  Forms forms;
  std::span<const FieldRow> fields;
  bool may_lack_color = false; ///< in the newer form
};
/// Null for an unknown word.
const ElementRow* find_element(std::string_view spelling);
/// "point diameter colour".
std::string describe_fields(const ElementRow& row);

/// A field's numbers and its place.
struct FieldValue {
  Vec3 numbers; ///< for a single number its x
  lang::Span place;
};

struct Element {
  const ElementRow* row;
  lang::Span place; ///< the whole line
  std::uint32_t line = 0;
  std::vector<FieldValue> fields; ///< as in the row; an omitted colour is missing at the end
};

/// A line as written: words separated by blanks, or a comment.
struct Line {
  std::uint32_t number = 0;
  std::vector<std::string_view> words;
  std::string_view comment; ///< without its mark
};
std::vector<Line> split_lines(std::string_view text);

/// Reads the fields of a line, `words` without the first; reports every field that is wrong. Empty if one is.
std::optional<std::vector<FieldValue>> read_fields(const ElementRow& row, std::span<const std::string_view> words,
                                                   const lang::SourceMap& sources, lang::Span line,
                                                   std::vector<lang::Diagnostic>& diagnostics);

} // namespace rt::tools::import::mini_rt
