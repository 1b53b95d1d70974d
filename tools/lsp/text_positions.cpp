#include "tools/lsp/text_positions.hpp"

#include "lang/text/utf8.hpp"

#include <algorithm>

namespace rt::tools::lsp {
namespace {

std::uint32_t units(const lang::Character& character, PositionEncoding encoding) {
  if (encoding == PositionEncoding::utf8) return static_cast<std::uint32_t>(character.bytes);
  return character.code_point > 0xffff ? 2 : 1;
}

} // namespace

LineTable::LineTable(std::string_view text) : text_(text), starts_{0} {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n' || (text[i] == '\r' && !(i + 1 < text.size() && text[i + 1] == '\n'))) starts_.push_back(i + 1);
}

TextPosition LineTable::position(std::size_t offset, PositionEncoding encoding) const {
  offset = std::min(offset, text_.size());
  const auto line = std::upper_bound(starts_.begin(), starts_.end(), offset) - starts_.begin() - 1;
  std::uint32_t character = 0;
  for (std::size_t at = starts_[static_cast<std::size_t>(line)]; at < offset;) {
    const lang::Character next = lang::decode(text_.substr(at));
    at += next.bytes;
    if (at <= offset) character += units(next, encoding);
  }
  return {static_cast<std::uint32_t>(line), character};
}

std::size_t LineTable::offset(TextPosition position, PositionEncoding encoding) const {
  if (position.line >= starts_.size()) return text_.size();
  std::size_t at = starts_[position.line];
  for (std::uint32_t character = 0; at < text_.size() && text_[at] != '\n' && text_[at] != '\r';) {
    const lang::Character next = lang::decode(text_.substr(at));
    character += units(next, encoding);
    if (character > position.character) break;
    at += next.bytes;
  }
  return at;
}

} // namespace rt::tools::lsp
