#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/render/film.hpp"
#include "tools/terminal/terminal.hpp"

#include <memory>
#include <string>
#include <string_view>

struct ChafaTermInfo;

namespace rt::tools {

/// How a terminal shows pictures.
enum class Graphics : std::uint8_t { text, half_blocks, sixel, kitty, iterm2 };

/// A picture's extent on the screen and in pixels.
struct PictureExtent {
  int columns = 0, rows = 0;
  int width = 0, height = 0;
};

/// Turns films into what a terminal shows. What it can show is told by the environment (TERM, COLORTERM, TERM_PROGRAM,
/// …) which form to take: kitty's or iTerm2's protocol or sixels where the terminal has them, coloured half blocks
/// elsewhere, and characters by brightness where the terminal takes no colours or output is no terminal.
/// RTLANG_GRAPHICS=sixel, kitty, iterm2, blocks or text overrules it.
class PicturePrinter {
public:
  explicit PicturePrinter(bool is_terminal);
  ~PicturePrinter();
  PicturePrinter(const PicturePrinter&) = delete;
  PicturePrinter& operator=(const PicturePrinter&) = delete;

  Graphics graphics() const { return graphics_; }
  /// To be called if the terminal itself reports them (see `attributes_query`).
  void use_sixels();
  /// Whether to query the terminal: the environment does not tell, and a reply would be used.
  bool wants_to_ask() const { return may_ask_; }

  /// The largest extent for a picture of this aspect ratio that leaves `spare_rows` of the screen free.
  PictureExtent fit(scene::Resolution size, const TerminalSize& terminal, int spare_rows) const;

  /// The film, scaled to `extent`, as text that ends at the beginning of the row below it.
  std::string print(const Film& film, const PictureExtent& extent) const;

private:
  struct Release {
    void operator()(ChafaTermInfo* info) const;
  };
  std::unique_ptr<ChafaTermInfo, Release> terminal_;
  Graphics graphics_ = Graphics::text;
  int color_mode_ = 0; // a ChafaCanvasMode
  bool may_ask_ = false;
};

/// Queries a terminal's attributes; in the reply (ESC [ ? … c) 4 means sixel support.
inline constexpr std::string_view attributes_query = "\x1b[c";
bool has_sixels(std::string_view attributes);

} // namespace rt::tools
