#include "tools/import/mini_rt_lines.hpp"

#include "lang/text/characters.hpp"
#include "lang/text/literals.hpp"
#include "tools/import/import_errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace rt::tools::import::mini_rt {
namespace {

constexpr FieldRow ratio{FieldKind::ratio, "ratio"}, color{FieldKind::color, "colour"},
    point{FieldKind::point, "point"}, direction{FieldKind::direction, "direction"},
    diameter{FieldKind::length, "diameter"}, height{FieldKind::length, "height"}, side{FieldKind::length, "side"},
    fov{FieldKind::angle, "field of view"};
constexpr FieldRow resolution[] = {{FieldKind::pixels, "width"}, {FieldKind::pixels, "height"}};
constexpr FieldRow ambient[] = {ratio, color};
constexpr FieldRow camera[] = {point, direction, fov};
constexpr FieldRow light[] = {point, ratio, color};
constexpr FieldRow sphere[] = {point, diameter, color};
constexpr FieldRow plane[] = {point, direction, color};
constexpr FieldRow cylinder[] = {point, direction, diameter, height, color};
constexpr FieldRow square[] = {point, direction, side, color};
constexpr FieldRow triangle[] = {point, point, point, color};
constexpr FieldRow disc[] = {point, direction, diameter, color};

constexpr ElementRow elements[] = {
    {Word::R, "R", Forms::older, resolution},  {Word::A, "A", Forms::both, ambient},
    {Word::C, "C", Forms::newer, camera},      {Word::c, "c", Forms::older, camera},
    {Word::L, "L", Forms::newer, light, true}, {Word::l, "l", Forms::older, light},
    {Word::sp, "sp", Forms::both, sphere},     {Word::pl, "pl", Forms::both, plane},
    {Word::cy, "cy", Forms::both, cylinder},   {Word::sq, "sq", Forms::older, square},
    {Word::tr, "tr", Forms::older, triangle},  {Word::co, "co", Forms::neither, cylinder},
    {Word::di, "di", Forms::neither, disc},
};

bool is_triple(FieldKind kind) {
  return kind == FieldKind::point || kind == FieldKind::direction || kind == FieldKind::color;
}
bool is_whole(FieldKind kind) {
  return kind == FieldKind::pixels || kind == FieldKind::color;
}

/// Sign, digits, perhaps a point among them: no exponent, no other letters.
std::optional<double> read_number(std::string_view word) {
  std::string_view rest = word;
  if (!rest.empty() && lang::is_sign(rest.front())) rest.remove_prefix(1);
  const bool is_plain = std::ranges::all_of(rest, [](char c) { return lang::is_digit(c) || c == '.'; });
  if (!is_plain || std::ranges::count(rest, '.') > 1 || !std::ranges::any_of(rest, lang::is_digit)) return std::nullopt;
  const lang::NumberLiteral number = lang::read_signed_number(word);
  if (number.length != word.size() || !std::isfinite(number.value)) return std::nullopt;
  return number.value;
}

/// What is wrong with a field's numbers; empty if nothing.
std::string complaint(FieldKind kind, const Vec3& v) {
  const auto within = [](double x, double low, double high) { return x >= low && x <= high; };
  switch (kind) {
  case FieldKind::ratio:
    return within(v.x, 0, 1) ? "" : "must be from 0 to 1";
  case FieldKind::length:
  case FieldKind::pixels:
    return v.x > 0 ? "" : "must be above 0";
  case FieldKind::angle:
    return within(v.x, 0, 180) ? "" : "must be from 0 to 180";
  case FieldKind::point:
    return "";
  case FieldKind::direction:
    if (!within(v.x, -1, 1) || !within(v.y, -1, 1) || !within(v.z, -1, 1)) return "must have numbers from -1 to 1";
    return length(v) > 0 ? "" : "must not be 0,0,0";
  case FieldKind::color:
    return within(v.x, 0, 255) && within(v.y, 0, 255) && within(v.z, 0, 255) ? "" : "must have numbers from 0 to 255";
  }
  return "";
}

std::string_view form_of(FieldKind kind) {
  if (kind == FieldKind::pixels) return "is a whole number: 800";
  if (kind == FieldKind::color) return "is three whole numbers with commas and no spaces: 255,0,100";
  return is_triple(kind) ? "is three numbers with commas and no spaces: 0,1.5,-2" : "is a number: 1.5";
}

/// The numbers of a field, if it has the form that its kind requires.
std::optional<Vec3> read_field(FieldKind kind, std::string_view word) {
  double numbers[3]{};
  const std::size_t count = is_triple(kind) ? 3 : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t comma = word.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == count)) return std::nullopt;
    const std::string_view part = word.substr(0, comma);
    const auto number = read_number(part);
    if (!number || (is_whole(kind) && part.find('.') != std::string_view::npos)) return std::nullopt;
    numbers[i] = *number;
    word.remove_prefix(std::min(word.size(), part.size() + 1));
  }
  return Vec3{numbers[0], numbers[1], numbers[2]};
}

} // namespace

const ElementRow* find_element(std::string_view spelling) {
  const auto* const row = std::ranges::find(elements, spelling, &ElementRow::spelling);
  return row == std::end(elements) ? nullptr : row;
}

std::string describe_fields(const ElementRow& row) {
  std::vector<std::string_view> names;
  for (const FieldRow& field : row.fields) names.push_back(field.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<Line> split_lines(std::string_view text) {
  std::vector<Line> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view rest = text.substr(0, end);
    text.remove_prefix(std::min(text.size(), end + 1));
    Line& line = lines.emplace_back();
    line.number = static_cast<std::uint32_t>(lines.size());
    for (;;) {
      while (!rest.empty() && lang::is_blank(rest.front())) rest.remove_prefix(1);
      if (rest.empty()) break;
      if (rest.front() == '#' || rest.starts_with("//")) {
        line.comment = rest.substr(rest.front() == '#' ? 1 : 2);
        while (!line.comment.empty() && lang::is_blank(line.comment.back())) line.comment.remove_suffix(1);
        break;
      }
      const auto* const stop = std::ranges::find_if(rest, lang::is_blank);
      line.words.emplace_back(rest.begin(), stop);
      rest.remove_prefix(line.words.back().size());
    }
  }
  return lines;
}

std::optional<std::vector<FieldValue>> read_fields(const ElementRow& row, std::span<const std::string_view> words,
                                                   const lang::SourceMap& sources, lang::Span line,
                                                   std::vector<lang::Diagnostic>& diagnostics) {
  const std::size_t before = diagnostics.size();
  const std::size_t least = row.fields.size() - (row.may_lack_color ? 1 : 0);
  if (words.size() < least || words.size() > row.fields.size()) {
    diagnostics.push_back(errors::malformed_line(line,
                                                 fmt::format("`{}` takes {} fields, not {}: {}", row.spelling,
                                                             row.fields.size(), words.size(), describe_fields(row)),
                                                 ""));
  }
  std::vector<FieldValue> values;
  const char* const start = sources.file(line.file).text.data();
  for (std::size_t i = 0; i < std::min(words.size(), row.fields.size()); ++i) {
    const FieldRow& field = row.fields[i];
    const auto begin = static_cast<std::uint32_t>(words[i].data() - start);
    const lang::Span place{line.file, begin, begin + static_cast<std::uint32_t>(words[i].size())};
    const auto numbers = read_field(field.kind, words[i]);
    if (!numbers)
      diagnostics.push_back(errors::malformed_line(
          place, fmt::format("the {} of `{}` {}", field.name, row.spelling, form_of(field.kind)), ""));
    else if (const std::string wrong = complaint(field.kind, *numbers); !wrong.empty())
      diagnostics.push_back(
          errors::malformed_line(place, fmt::format("the {} of `{}` {}", field.name, row.spelling, wrong), ""));
    else
      values.push_back({*numbers, place});
  }
  if (diagnostics.size() > before) return std::nullopt;
  return values;
}

} // namespace rt::tools::import::mini_rt
