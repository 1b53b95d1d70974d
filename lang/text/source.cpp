#include "lang/text/source.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace rt::lang {

namespace {
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf"; // some editors put it first; it is not part of line 1
}

FileId SourceMap::add(std::string name, std::string path, std::string text, Span included_from) {
  if (text.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error(name + ": a scene file may be at most 4 GB");
  }
  const auto id = static_cast<FileId>(files_.size());
  SourceFile file{std::move(name), std::move(path), std::move(text), {0}, included_from};
  if (included_from == Span{}) file.included_from.file = id;
  if (file.text.starts_with(byte_order_mark)) file.line_starts[0] = byte_order_mark.size();
  const char* const begin = file.text.data();
  const char* const end = begin + file.text.size();
  for (const char* at = begin; at != end;) {
    const void* const newline = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
    if (newline == nullptr) break;
    at = static_cast<const char*>(newline) + 1;
    file.line_starts.push_back(static_cast<std::uint32_t>(at - begin));
  }
  files_.push_back(std::move(file));
  return id;
}

std::string_view SourceMap::text(Span span) const {
  const std::string_view text = files_[span.file].text;
  assert(span.begin <= span.end && span.end <= text.size());
  return text.substr(span.begin, span.end - span.begin);
}

Position SourceMap::position(FileId file, std::uint32_t offset) const {
  const SourceFile& source = files_[file];
  offset = std::max(offset, source.line_starts[0]);
  const auto next = std::upper_bound(source.line_starts.begin(), source.line_starts.end(), offset);
  const auto line = static_cast<std::uint32_t>(next - source.line_starts.begin());
  const std::uint32_t start = next[-1];
  const std::string_view before = std::string_view(source.text).substr(start, offset - start);
  // Every byte except UTF-8 continuation bytes begins a character.
  const auto characters = std::count_if(before.begin(), before.end(), [](char c) { return (c & 0xc0) != 0x80; });
  return {line, static_cast<std::uint32_t>(characters) + 1};
}

std::string_view SourceMap::line(FileId file, std::uint32_t line) const {
  const SourceFile& source = files_[file];
  const std::uint32_t begin = source.line_starts[line - 1];
  const std::size_t end = line < source.line_starts.size() ? source.line_starts[line] : source.text.size();
  std::string_view text = std::string_view(source.text).substr(begin, end - begin);
  if (text.ends_with('\n')) text.remove_suffix(1);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

} // namespace rt::lang
