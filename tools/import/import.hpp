#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Scenes of other programs, as text in our language.
namespace rt::tools::import {

struct Options {
  bool is_lenient = false; ///< accepts common forms that the format does not have, and skips what it cannot accept
  std::array<int, 2> size{1280, 720};   ///< of the picture, if the file does not specify it
  bool cylinders_stand_on_foot = false; ///< miniRT: a cylinder's point is the centre of its base, not of the cylinder
};

/// A file in our language.
struct Imported {
  /// A statement for each line of the file that is not blank, on the same line: so places in it are places in the file.
  /// Empty if the file has errors.
  std::string by_line;
  /// The same as one would write it, formatted.
  std::string text;
  std::vector<lang::Diagnostic> diagnostics; ///< all errors and warnings about the file, with its own line numbers
  lang::SourceMap sources;                   ///< the file

  bool has_errors() const;
};

/// A format that can be read.
struct Format {
  std::string_view name, extension; ///< "miniRT", ".rt"
  /// `name` is the file's name in messages.
  Imported (*read)(std::string text, const std::string& name, const Options& options);
};

/// All of them.
std::span<const Format> formats();
/// The format of a file of that name; null where it is none of another program's.
const Format* format_of(std::string_view path);

} // namespace rt::tools::import
