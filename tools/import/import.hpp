#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Scenes of other programs, as text of our language.
namespace rt::tools::import {

struct Options {
  bool is_lenient = false; ///< takes common forms that the format does not have, and leaves out what it cannot take
  std::array<int, 2> size{1280, 720};   ///< of the picture, where the file does not say
  bool cylinders_stand_on_foot = false; ///< miniRT: a cylinder's point is its foot, not its middle
};

/// A file in our language.
struct Imported {
  /// A statement for each line of the file that says something, on that line: so places in it are places in the file.
  /// Empty where the file is wrong.
  std::string by_line;
  /// The same as one would type it, formatted.
  std::string text;
  std::vector<lang::Diagnostic> diagnostics; ///< all mistakes of the file and warnings, in its own lines
  lang::SourceMap sources;                   ///< the file

  bool has_errors() const;
};

/// A format that can be read.
struct Format {
  std::string_view name, extension; ///< "miniRT", ".rt"
  /// `name` is what the file is called in messages.
  Imported (*read)(std::string text, const std::string& name, const Options& options);
};

/// All of them.
std::span<const Format> formats();
/// The format of a file of that name; null where it is none of another program's.
const Format* format_of(std::string_view path);

} // namespace rt::tools::import
