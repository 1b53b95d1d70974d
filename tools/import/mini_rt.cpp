#include "tools/import/mini_rt.hpp"

#include "lang/format/format.hpp"
#include "renderer/math/format_number.hpp"
#include "tools/import/import_errors.hpp"
#include "tools/import/mini_rt_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rt::tools::import {
namespace {

using namespace mini_rt;

std::string text_of(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", format_number(v.x), format_number(v.y), format_number(v.z));
}

/// v/255, which is linear light.
std::string channel(double v) {
  return v == 0 || v == 255 ? format_number(v / 255) : fmt::format("{} / 255", format_number(v));
}
std::string color_text(const Vec3& v) {
  if (v == Vec3{255, 255, 255}) return "white";
  if (v == Vec3{}) return "black";
  return fmt::format("linear_rgb({}, {}, {})", channel(v.x), channel(v.y), channel(v.z));
}

/// How a surface with a colour is written.
using MaterialText = std::string (*)(const Vec3& color);
std::string inline_material(const Vec3& color) {
  return fmt::format("material {{ color: {}, diffuse: 1 }}", color_text(color));
}
std::string called_material(const Vec3& v) {
  return fmt::format("paint({}, {}, {})", format_number(v.x), format_number(v.y), format_number(v.z));
}
constexpr std::string_view paint_definition =
    "fn paint(r, g, b) = material { color: linear_rgb(r / 255, g / 255, b / 255), diffuse: 1 }\n";

class Reader {
public:
  Reader(std::string text, const std::string& name, const Options& options) : options_(options) {
    file_ = imported_.sources.add(name, {}, std::move(text));
    lines_ = split_lines(imported_.sources.file(file_).text);
  }

  Imported run() {
    find_form();
    for (const Line& line : lines_)
      if (!line.words.empty()) read(line);
    check_counts();
    std::ranges::stable_sort(imported_.diagnostics, {}, [](const auto& d) { return d.span.begin; });
    if (imported_.has_errors()) return std::move(imported_);
    write();
    return std::move(imported_);
  }

private:
  lang::Span place_of(std::string_view words) const {
    const auto begin = static_cast<std::uint32_t>(words.data() - imported_.sources.file(file_).text.data());
    return {file_, begin, begin + static_cast<std::uint32_t>(words.size())};
  }
  lang::Span place_of(const Line& line) const {
    return {file_, place_of(line.words.front()).begin, place_of(line.words.back()).end};
  }
  void add(lang::Diagnostic diagnostic) { imported_.diagnostics.push_back(std::move(diagnostic)); }
  void warn(lang::Span place, std::string message, std::string label = {}) {
    add(errors::taken_otherwise(place, std::move(message), std::move(label)));
  }

  bool has(std::string_view word) const {
    return std::ranges::any_of(lines_, [&](const Line& l) { return !l.words.empty() && l.words.front() == word; });
  }
  void find_form() { is_older_ = has("R") || ((has("c") || has("l")) && !has("C")); }

  // The element that the word means in this version; if lenient, a `c` may be written `C`.
  const ElementRow* element(std::string_view word) const {
    if (options_.is_lenient && is_older_ && (word == "C" || word == "L")) word = word == "C" ? "c" : "l";
    return find_element(word);
  }

  bool is_of_this_form(const ElementRow& row) const {
    return row.forms == Forms::both || row.forms == (is_older_ ? Forms::older : Forms::newer);
  }

  void read(const Line& line) {
    const std::string_view word = line.words.front();
    const ElementRow* const row = element(word);
    if (!row || (!options_.is_lenient && !is_of_this_form(*row))) return refuse(line, row);
    std::span<const std::string_view> fields(line.words);
    fields = fields.subspan(1);
    if (options_.is_lenient && fields.size() > row->fields.size()) {
      warn(place_of(fields[row->fields.size()]), fmt::format("extra text after the fields of `{}` is ignored", word));
      fields = fields.first(row->fields.size());
    }
    auto values = read_fields(*row, fields, imported_.sources, place_of(line), imported_.diagnostics);
    counts_[row->word].push_back(place_of(line));
    if (!values) return;
    for (std::size_t i = 0; i < values->size(); ++i) check_value(*row, row->fields[i], (*values)[i]);
    elements_.push_back({row, place_of(line), line.number, std::move(*values)});
  }

  void refuse(const Line& line, const ElementRow* row) {
    const std::string_view word = line.words.front();
    if (!row && options_.is_lenient)
      return warn(place_of(line), fmt::format("`{}` is not a miniRT element: ignored", word));
    const std::string_view form =
        is_older_ ? "the 2019 format, recognised by `R` and lower-case letters" : "the 2021 format";
    const std::string_view known = is_older_ ? "R, A, c, l, sp, pl, sq, cy and tr" : "A, C, L, sp, pl and cy";
    add(errors::unknown_element(place_of(word),
                                row ? fmt::format("`{}` does not belong to {}", word, form)
                                    : fmt::format("`{}` is not a miniRT element", word),
                                fmt::format("this file is of {}, which has {}; --lenient {}", form, known,
                                            row ? "takes this one too" : "leaves this line out")));
  }

  void check_value(const ElementRow& row, const FieldRow& field, FieldValue& value) {
    if (field.kind == FieldKind::direction) {
      const double size = length(value.numbers);
      if (std::abs(size - 1) > 1e-3)
        warn(value.place, fmt::format("the direction of `{}` has length {:.4g}", row.spelling, size),
             "it is normalised");
    }
    if (field.kind == FieldKind::angle && (value.numbers.x == 0 || value.numbers.x == 180)) {
      const double drawn = value.numbers.x == 0 ? 0.01 : 179.99;
      warn(value.place, fmt::format("a field of view of {}° cannot be drawn on a flat picture", value.numbers.x),
           fmt::format("{} is taken", drawn));
      value.numbers.x = drawn;
    }
  }

  void require_one(Word word, std::string_view what, bool may_be_more = false) {
    const auto& places = counts_[word];
    if (places.empty()) {
      const auto end = static_cast<std::uint32_t>(imported_.sources.file(file_).text.size());
      add(errors::wrong_count({file_, end, end}, fmt::format("the file has no {}", what)));
    }
    if (!may_be_more) allow_one(word, what, "");
  }

  void allow_one(Word word, std::string_view what, std::string_view advice) {
    const auto& places = counts_[word];
    for (std::size_t i = 1; i < places.size(); ++i) {
      std::vector<lang::Note> notes{{places[0], "the first one"}};
      if (!advice.empty()) notes.push_back({std::nullopt, std::string(advice)});
      add(errors::wrong_count(places[i], fmt::format("a file has one {}", what), std::move(notes)));
    }
  }

  void check_counts() {
    require_one(Word::A, "ambient light (`A`)");
    if (is_older_) {
      if (!options_.is_lenient) require_one(Word::R, "resolution (`R`)");
      require_one(Word::c, "camera (`c`)", true);
    } else {
      require_one(Word::C, "camera (`C`)");
      if (!options_.is_lenient) allow_one(Word::L, "lamp (`L`)", "the bonus part allows more: --lenient accepts them");
    }
  }

  void write() {
    const std::array<int, 2> size = picture_size();
    const std::string first = fmt::format("size: [{}, {}]", size[0], size[1]);
    std::string& by_line = imported_.by_line;
    std::string typed =
        fmt::format("// {}, a scene of miniRT. Its colours are light itself; pictures are encoded in sRGB "
                    "here and look\n// lighter than in its windows.\n{}\n{}",
                    imported_.sources.file(file_).name, first, paint_definition);
    std::size_t next = 0;
    bool has_size = false, has_camera = false;
    for (const Line& line : lines_) {
      if (!line.comment.empty()) typed += fmt::format("//{}\n", line.comment);
      if (line.words.empty() && line.comment.empty()) typed += '\n';
      if (next < elements_.size() && elements_[next].line == line.number) {
        const Element& element = elements_[next++];
        const bool is_further = is_camera(element) && std::exchange(has_camera, has_camera || is_camera(element));
        const std::string here = is_further ? "" : statement(element, inline_material);
        by_line += has_size || here.empty() ? here : first + ", " + here;
        has_size = has_size || !here.empty();
        typed += fmt::format("{}{}\n", is_further ? "// another view: " : "", statement(element, called_material));
      }
      by_line += '\n';
    }
    lang::SourceMap sources;
    imported_.text = lang::format(sources, sources.add("", {}, std::move(typed))).text;
  }

  static bool is_camera(const Element& element) { return element.row->word == Word::C || element.row->word == Word::c; }

  std::array<int, 2> picture_size() const {
    const auto row = std::ranges::find(elements_, Word::R, [](const Element& e) { return e.row->word; });
    if (row == elements_.end()) return options_.size;
    // The school's programs clamp it to the screen.
    const auto side = [&](std::size_t i) { return static_cast<int>(std::min(row->fields[i].numbers.x, 16384.0)); };
    return {side(0), side(1)};
  }

  std::string statement(const Element& e, MaterialText material) const {
    const auto vector = [&](std::size_t i) { return text_of(e.fields[i].numbers); };
    const auto number = [&](std::size_t i, double factor = 1) { return format_number(e.fields[i].numbers.x * factor); };
    const std::string surface = fmt::format("material: {}", material(e.fields.back().numbers));
    switch (e.row->word) {
    case Word::R:
      return "";
    case Word::A:
      return ambient(e);
    case Word::C:
    case Word::c:
      return camera(e);
    case Word::L:
    case Word::l:
      return lamp(e);
    case Word::sp:
      return fmt::format("sphere {{ at: {}, radius: {}, {} }}", vector(0), number(1, 0.5), surface);
    case Word::pl:
      return fmt::format("plane {{ {}, {} }}", plane(e), surface);
    case Word::cy:
      return fmt::format("cylinder {{ at: {}, axis: {}, height: {}, radius: {}{}, {} }}", text_of(middle(e)), vector(1),
                         number(3), number(2, 0.5), is_older_ ? ", open: true" : "", surface);
    case Word::sq:
      return fmt::format("quad {{ at: {}, normal: {}, size: {}, {} }}", vector(0), vector(1), number(2), surface);
    case Word::tr:
      return fmt::format("triangle {{ points: [{}, {}, {}], {} }}", vector(0), vector(1), vector(2), surface);
    case Word::co:
      return fmt::format("cone {{ from: {}, to: {}, radius: {}, {} }}", vector(0),
                         text_of(e.fields[0].numbers + normalize(e.fields[1].numbers) * e.fields[3].numbers.x),
                         number(2, 0.5), surface);
    case Word::di:
      return fmt::format("disc {{ at: {}, normal: {}, radius: {}, {} }}", vector(0), vector(1), number(2, 0.5),
                         surface);
    }
    return "";
  }

  static std::string ambient(const Element& e) {
    const std::string ratio = format_number(e.fields[0].numbers.x), color = color_text(e.fields[1].numbers);
    return color == "white" ? fmt::format("ambient: {}", ratio) : fmt::format("ambient: {} * {}", color, ratio);
  }

  static std::string camera(const Element& e) {
    const Vec3 &at = e.fields[0].numbers, &direction = e.fields[1].numbers;
    const bool is_upright = direction.x == 0 && direction.z == 0;
    return fmt::format("camera {{ at: {}, look_at: {}, {}fov: {} }}", text_of(at), text_of(at + direction),
                       is_upright ? "up: [0, 0, 1], " : "", format_number(e.fields[2].numbers.x));
  }

  static std::string lamp(const Element& e) {
    const Vec3 white{255, 255, 255}, color = e.fields.size() > 2 ? e.fields[2].numbers : white;
    return fmt::format("light {{ at: {}, intensity: {}{} }}", text_of(e.fields[0].numbers),
                       format_number(e.fields[1].numbers.x), color == white ? "" : ", color: " + color_text(color));
  }

  static std::string plane(const Element& e) {
    const Vec3 &point = e.fields[0].numbers, &n = e.fields[1].numbers;
    if (n.y == 0 && n.z == 0) return "x: " + format_number(point.x);
    if (n.x == 0 && n.z == 0) return "y: " + format_number(point.y);
    if (n.x == 0 && n.y == 0) return "z: " + format_number(point.z);
    return fmt::format("normal: {}, at: {}", text_of(n), text_of(point));
  }

  Vec3 middle(const Element& e) const {
    const Vec3& point = e.fields[0].numbers;
    return options_.cylinders_stand_on_foot ? point + normalize(e.fields[1].numbers) * (e.fields[3].numbers.x / 2)
                                            : point;
  }

  const Options& options_;
  Imported imported_;
  lang::FileId file_ = 0;
  std::vector<Line> lines_;
  bool is_older_ = false;
  std::vector<Element> elements_;
  std::map<Word, std::vector<lang::Span>> counts_;
};

} // namespace

Imported read_mini_rt(std::string text, const std::string& name, const Options& options) {
  return Reader(std::move(text), name, options).run();
}

} // namespace rt::tools::import
