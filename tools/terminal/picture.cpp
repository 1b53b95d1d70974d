#include "tools/terminal/picture.hpp"

#include "renderer/math/color.hpp"
#include "tools/terminal/console.hpp"

#include <chafa.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace rt::tools {
namespace {

struct CanvasConfigRelease {
  void operator()(ChafaCanvasConfig* config) const { chafa_canvas_config_unref(config); }
};
struct CanvasRelease {
  void operator()(ChafaCanvas* canvas) const { chafa_canvas_unref(canvas); }
};
struct SymbolsRelease {
  void operator()(ChafaSymbolMap* symbols) const { chafa_symbol_map_unref(symbols); }
};

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

Graphics detect(const ChafaTermInfo* info) {
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_BEGIN_KITTY_IMMEDIATE_IMAGE_V1)) return Graphics::kitty;
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_BEGIN_ITERM2_IMAGE)) return Graphics::iterm2;
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_BEGIN_SIXELS)) return Graphics::sixel;
  return Graphics::half_blocks;
}

ChafaCanvasMode detect_colors(const ChafaTermInfo* info) {
  const std::string_view color = environment("COLORTERM");
  if (color == "truecolor" || color == "24bit") return CHAFA_CANVAS_MODE_TRUECOLOR;
  const std::string_view name = environment("TERM");
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_SET_COLOR_FGBG_DIRECT) &&
      name.find("256") == std::string_view::npos)
    return CHAFA_CANVAS_MODE_TRUECOLOR;
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_SET_COLOR_FGBG_256)) return CHAFA_CANVAS_MODE_INDEXED_240;
  return CHAFA_CANVAS_MODE_INDEXED_16;
}

ChafaPixelMode pixel_mode(Graphics graphics) {
  switch (graphics) {
  case Graphics::sixel:
    return CHAFA_PIXEL_MODE_SIXELS;
  case Graphics::kitty:
    return CHAFA_PIXEL_MODE_KITTY;
  case Graphics::iterm2:
    return CHAFA_PIXEL_MODE_ITERM2;
  case Graphics::half_blocks:
  case Graphics::text:
    break;
  }
  return CHAFA_PIXEL_MODE_SYMBOLS;
}

// Linear light to 8-bit sRGB by a table that is accurate to half a step everywhere but in the darkest tones, where a
// preview may be one step off.
class Encoder {
public:
  Encoder() {
    for (std::size_t i = 0; i < table_.size(); ++i)
      table_[i] = static_cast<std::uint8_t>(
          linear_to_srgb(static_cast<double>(i) / static_cast<double>(table_.size() - 1)) * 255 + 0.5);
  }
  std::uint8_t operator()(float linear) const {
    const float last = static_cast<float>(table_.size() - 1);
    return table_[static_cast<std::size_t>(std::clamp(linear, 0.0F, 1.0F) * last + 0.5F)];
  }

private:
  std::array<std::uint8_t, 8192> table_;
};

// With an alpha channel: libchafa misreads rows of three bytes per pixel unless their length is a multiple of four.
std::vector<std::uint8_t> encode(const Film& film) {
  static const Encoder encoder;
  const ToneCurve curve(film.tone_mapping);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(film.color.size() * 4);
  for (const Rgb32& c : film.color)
    bytes.insert(bytes.end(), {encoder(curve(c.r)), encoder(curve(c.g)), encoder(curve(c.b)), 255});
  return bytes;
}

// Perceived lightness of linear light, 0 to 1 (CIE 1976 L*/100 of its luminance, with the weights of Rec. 709).
double lightness(const Rgb32& c) {
  const auto part = [](float v) { return std::clamp(static_cast<double>(v), 0.0, 1.0); };
  const double y = 0.2126 * part(c.r) + 0.7152 * part(c.g) + 0.0722 * part(c.b);
  return y > 216.0 / 24389 ? 1.16 * std::cbrt(y) - 0.16 : y * 24389 / 2700;
}

// Characters only: the lighter a cell, the more of it its character fills.
std::string in_characters(const Film& film, const PictureExtent& extent) {
  constexpr std::string_view ramp = " .:-=+*#%@";
  std::string text;
  for (int row = 0; row < extent.rows; ++row) {
    for (int column = 0; column < extent.columns; ++column) {
      double sum = 0;
      int count = 0;
      for (int y = row * film.height / extent.rows; y < (row + 1) * film.height / extent.rows; ++y)
        for (int x = column * film.width / extent.columns; x < (column + 1) * film.width / extent.columns; ++x, ++count)
          sum += lightness(film.color[film.index(x, y)]);
      const double mean = count > 0 ? sum / count : 0;
      text += ramp[static_cast<std::size_t>(std::lround(mean * static_cast<double>(ramp.size() - 1)))];
    }
    text += '\n';
  }
  return text;
}

// Terminals differ in where a picture leaves the cursor. So the rows are created first, and the cursor is moved back to
// their beginning explicitly.
std::string framed(std::string_view picture, int rows) {
  const std::string room(static_cast<std::size_t>(rows), '\n');
  return fmt::format("{}\x1b[{}A\x1b"
                     "7{}\x1b"
                     "8\x1b[{}B\r",
                     room, rows, picture, rows);
}

// The size of a cell in pixels, if the terminal does not report it: the shape of most fonts.
constexpr int usual_cell_width = 8, usual_cell_height = 16;

} // namespace

bool has_sixels(std::string_view attributes) {
  std::size_t begin = attributes.find('?');
  while (begin != std::string_view::npos) {
    ++begin;
    const std::size_t end = attributes.find_first_of(";c", begin);
    if (attributes.substr(begin, end - begin) == "4") return true;
    begin = attributes.find(';', begin);
  }
  return false;
}

void PicturePrinter::Release::operator()(ChafaTermInfo* info) const {
  chafa_term_info_unref(info);
}

PicturePrinter::PicturePrinter(bool is_terminal) {
  ChafaTermDb* db = chafa_term_db_get_default();
  terminal_.reset(chafa_term_db_detect(db, environ));
  color_mode_ = detect_colors(terminal_.get());
  if (is_terminal && terminal_takes_color()) {
    graphics_ = detect(terminal_.get());
    may_ask_ = graphics_ == Graphics::half_blocks;
  }
  constexpr std::array<std::string_view, 5> names{"text", "blocks", "sixel", "kitty", "iterm2"};
  const auto wanted = std::find(names.begin(), names.end(), environment("RTLANG_GRAPHICS"));
  if (wanted != names.end()) {
    graphics_ = static_cast<Graphics>(wanted - names.begin());
    may_ask_ = false;
  }
  // The database's fallback knows every sequence, even those that the environment does not promise.
  ChafaTermInfo* fallback = chafa_term_db_get_fallback_info(db);
  chafa_term_info_supplement(terminal_.get(), fallback);
  chafa_term_info_unref(fallback);
}

PicturePrinter::~PicturePrinter() = default;

void PicturePrinter::use_sixels() {
  graphics_ = Graphics::sixel;
  may_ask_ = false;
}

PictureExtent PicturePrinter::fit(scene::Resolution size, const TerminalSize& terminal, int spare_rows) const {
  int cell_width = usual_cell_width, cell_height = usual_cell_height;
  if (terminal.pixel_width > 0 && terminal.pixel_height > 0) {
    cell_width = std::max(1, terminal.pixel_width / terminal.columns);
    cell_height = std::max(1, terminal.pixel_height / terminal.rows);
  }
  PictureExtent extent{std::max(1, terminal.columns - 1), std::max(1, terminal.rows - spare_rows)};
  const double ratio = static_cast<double>(cell_width) / cell_height;
  chafa_calc_canvas_geometry(size[0], size[1], &extent.columns, &extent.rows, static_cast<gfloat>(ratio), TRUE, FALSE);
  const bool has_pixels = pixel_mode(graphics_) != CHAFA_PIXEL_MODE_SYMBOLS;
  // Half blocks: two pixels a cell, each the mean of 2 × 2.
  extent.width = extent.columns * (has_pixels ? cell_width : 2);
  extent.height = extent.rows * (has_pixels ? cell_height : 4);
  if (has_pixels) {
    extent.width = std::min(extent.width, extent.height * size[0] / size[1]);
    extent.height = std::max(1, extent.width * size[1] / size[0]);
  }
  return extent;
}

std::string PicturePrinter::print(const Film& film, const PictureExtent& extent) const {
  if (graphics_ == Graphics::text) return in_characters(film, extent);
  const std::unique_ptr<ChafaCanvasConfig, CanvasConfigRelease> config(chafa_canvas_config_new());
  chafa_canvas_config_set_geometry(config.get(), extent.columns, extent.rows);
  chafa_canvas_config_set_pixel_mode(config.get(), pixel_mode(graphics_));
  chafa_canvas_config_set_work_factor(config.get(), 0.2F);
  chafa_canvas_config_set_color_extractor(config.get(), CHAFA_COLOR_EXTRACTOR_AVERAGE);
  const bool has_pixels = pixel_mode(graphics_) != CHAFA_PIXEL_MODE_SYMBOLS;
  if (has_pixels)
    chafa_canvas_config_set_cell_geometry(config.get(), std::max(1, extent.width / extent.columns),
                                          std::max(1, extent.height / extent.rows));
  const std::unique_ptr<ChafaSymbolMap, SymbolsRelease> symbols(chafa_symbol_map_new());
  chafa_symbol_map_add_by_tags(symbols.get(),
                               static_cast<ChafaSymbolTags>(CHAFA_SYMBOL_TAG_VHALF | CHAFA_SYMBOL_TAG_SPACE));
  chafa_canvas_config_set_canvas_mode(config.get(), has_pixels ? CHAFA_CANVAS_MODE_TRUECOLOR
                                                               : static_cast<ChafaCanvasMode>(color_mode_));
  chafa_canvas_config_set_symbol_map(config.get(), symbols.get());

  const std::unique_ptr<ChafaCanvas, CanvasRelease> canvas(chafa_canvas_new(config.get()));
  const std::vector<std::uint8_t> pixels = encode(film);
  chafa_canvas_draw_all_pixels(canvas.get(), CHAFA_PIXEL_RGBA8_UNASSOCIATED, pixels.data(), film.width, film.height,
                               film.width * 4);
  GString* text = chafa_canvas_print(canvas.get(), terminal_.get());
  std::string out(text->str, text->len);
  g_string_free(text, TRUE);
  if (has_pixels) return framed(out, extent.rows);
  if (out.empty() || out.back() != '\n') out += '\n';
  return out;
}

} // namespace rt::tools
