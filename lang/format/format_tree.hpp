#pragma once

#include "lang/text/tokens.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// What the formatter works on: the tokens of a text, grouped by brackets and separators, with comments in place.
namespace rt::lang::layout {

struct Group;

/// A token, a comment or a whole bracketed group within an entry.
struct Piece {
  TokenKind kind;
  std::string_view text;        ///< of a group: its opening bracket
  bool begins_line = false;     ///< it is first on a line, though not first in its entry
  std::unique_ptr<Group> group; ///< null for a token
};

/// An item of a block, an element of a list, an argument; or a comment on a line of its own.
struct FormatEntry {
  std::vector<Piece> pieces;
  std::string_view trailing_comment; ///< after it on its line
  bool begins_line = false;
  bool follows_blank_line = false;
  bool is_comment = false;
  bool needs_comma = false; ///< although it ends its line, because of what the next one begins with
  /// For an item that begins with a name and `=` or a block: the distance of that sign from the item's beginning. If
  /// consecutive items agree, they are meant to be aligned.
  std::size_t sign_column = 0;
  /// The column of its trailing comment, for the same purpose.
  std::size_t comment_column = 0;
};

/// A bracket pair and its contents; the whole file is one without brackets.
struct Group {
  char bracket = '{';
  std::vector<FormatEntry> entries;
  std::string_view opening_comment; ///< after the opening bracket on its line
  bool is_broken = false;           ///< it has line breaks of its own, not only in inner groups
  bool ends_on_new_line = false;    ///< the closing bracket begins a line
  bool is_filled = false;           ///< a list with as many elements per line as fit
};

/// Requires a text that parses.
Group read(std::string_view text);

bool is_comment(TokenKind kind);

} // namespace rt::lang::layout
