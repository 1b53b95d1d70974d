#include "tools/inspect/scene_json.hpp"

#include "tools/inspect/describe.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>

namespace rt::tools {
namespace {

/// Writes JSON: the members of the whole on lines of their own, and the elements of its lists of objects too.
class JsonSink {
public:
  static constexpr bool has_origins = true;

  explicit JsonSink(const std::function<void(std::string_view)>& write) : write_(write) {}
  JsonSink(const JsonSink&) = delete;
  JsonSink& operator=(const JsonSink&) = delete;

  void begin_object() { open('{', depth_ == 2); }
  void end_object() { close('}'); }
  void begin_array() { open('[', false); }
  void end_array() { close(']'); }
  void key(std::string_view name) {
    separate(depth_ == 1);
    quote(name);
    text_ += ": ";
    after_key_ = true;
  }
  void number(double value) {
    separate(false);
    if (!std::isfinite(value)) return quote(std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text_.append(digits, end);
  }
  void boolean(bool value) {
    separate(false);
    text_ += value ? "true" : "false";
  }
  void string(std::string_view value) {
    separate(false);
    quote(value);
  }
  void finish() {
    text_ += '\n';
    write_(text_);
    text_.clear();
  }

private:
  void open(char bracket, bool on_new_line) {
    separate(on_new_line && !after_key_);
    text_ += bracket;
    is_first_ = true;
    ++depth_;
    if (depth_ < 8) has_lines_[static_cast<std::size_t>(depth_)] = false;
  }
  void close(char bracket) {
    const bool had_lines = depth_ < 8 && has_lines_[static_cast<std::size_t>(depth_)];
    --depth_;
    if (had_lines) new_line();
    text_ += bracket;
    is_first_ = false;
    if (text_.size() < std::size_t{1} << 20) return;
    write_(text_);
    text_.clear();
  }
  void separate(bool on_new_line) {
    if (after_key_) {
      after_key_ = false;
      return;
    }
    if (!is_first_) text_ += on_new_line ? "," : ", ";
    is_first_ = false;
    if (!on_new_line) return;
    if (depth_ < 8) has_lines_[static_cast<std::size_t>(depth_)] = true;
    new_line();
  }
  void new_line() {
    text_ += '\n';
    text_.append(2 * static_cast<std::size_t>(depth_), ' ');
  }
  void quote(std::string_view value) {
    text_ += '"';
    for (const char c : value) {
      if (c == '"' || c == '\\') text_ += '\\';
      if (static_cast<unsigned char>(c) < 0x20)
        text_ += fmt::format("\\u{:04x}", static_cast<int>(c));
      else
        text_ += c;
    }
    text_ += '"';
  }

  const std::function<void(std::string_view)>& write_;
  std::string text_;
  int depth_ = 0;
  bool is_first_ = true;
  bool after_key_ = false;
  bool has_lines_[8] = {}; ///< whether the contents of the open bracket at each depth are on lines of their own
};

} // namespace

void write_scene_json(const scene::Scene& scene, const std::function<void(std::string_view)>& write) {
  JsonSink sink(write);
  Describer(scene, sink).scene();
  sink.finish();
}

} // namespace rt::tools
