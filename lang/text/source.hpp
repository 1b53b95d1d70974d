#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

/// Index of a file in a `SourceMap`.
using FileId = std::uint32_t;

/// A range of a source file: byte offsets, `end` exclusive.
struct Span {
  FileId file = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// Line and column from 1; the column counts characters (UTF-8 code points), not bytes.
struct Position {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

/// A text that was read: a scene file, an included file, standard input, a line typed into a session.
struct SourceFile {
  std::string name; ///< as shown in diagnostics
  std::string path; ///< canonical, empty if there is none; relative includes are resolved against it
  std::string text;
  std::vector<std::uint32_t> line_starts; ///< byte offset of each line's first character
  /// Where `include` or `use` named this file; for the first one the file is itself.
  Span included_from;
};

/// All texts of one run.
class SourceMap {
public:
  /// Throws std::length_error for a text too long for 32-bit offsets.
  FileId add(std::string name, std::string path, std::string text, Span included_from = {});
  const SourceFile& file(FileId id) const { return files_[id]; }
  std::size_t size() const { return files_.size(); }
  std::string_view text(Span span) const;
  Position position(FileId file, std::uint32_t offset) const;
  std::string_view line(FileId file, std::uint32_t line) const; ///< without its line ending

private:
  std::vector<SourceFile> files_;
};

} // namespace rt::lang
