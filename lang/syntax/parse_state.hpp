#pragma once

#include "lang/syntax/ast_builder.hpp"
#include "lang/syntax/errors/syntax_errors.hpp"
#include "lang/syntax/parse.hpp"
#include "lang/syntax/repeat_folder.hpp"
#include "lang/text/words.hpp"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace rt::lang {

/// Thrown if the grammar cannot continue; the diagnostic is already recorded.
struct SyntaxError {
  std::uint32_t at;      ///< where to start looking for the end of the broken item
  bool is_fatal = false; ///< nothing after it can be trusted
};

// In the mark of a construct, instead of a name.
inline constexpr Symbol chained_if{0xfffffffe};         ///< an `else if`: part of the `if` before it
inline constexpr Symbol comprehension_mark{0xfffffffd}; ///< a list that turned out to be a comprehension

/// What the grammar's rules and actions share while one text is parsed.
class ParseState {
public:
  ParseState(const SourceMap& sources, FileId file, SymbolTable& symbols, const ParseOptions& options, Ast& ast);

  std::string_view text;
  FileId file;
  SymbolTable& symbols;
  const ParseOptions& options;
  AstBuilder build;
  std::vector<Diagnostic> diagnostics;

  /// The word that was read last.
  struct {
    Word word;
    std::uint32_t begin, end;
  } last{};
  void read_word(std::uint32_t begin, std::uint32_t end);
  Symbol symbol() const { return symbols.intern(text.substr(last.begin, last.end - last.begin)); }

  // Questions that the grammar asks
  bool newline_is_space() const { return newline_is_space_; }
  bool block_may_follow() const { return block_may_follow_; }
  bool brace_may_be_misplaced() const { return block_may_follow_ && (open_.empty() || open_.back().bracket != '['); }
  bool is_in_braces() const { return !open_.empty(); }
  bool word_is_plain() const { return !is_reserved(last.word); }
  bool word_is_reserved() const { return is_reserved(last.word); }
  bool word_is_primary() const;
  bool word_is_infix() const { return last.word == Word::and_ || last.word == Word::or_ || last.word == Word::by_; }
  bool may_edit_previous() const { return options.is_session && build.count() == 0 && open_.empty(); }
  bool follows_line() const { return follows_line_; }

  // Called by the grammar
  void begin_items();
  void separator(bool is_newline) { follows_line_ = is_newline; }
  struct Modes {
    bool newline_is_space, block_may_follow;
  };
  Modes enter(std::uint32_t at, char bracket);
  void leave(Modes modes);
  enum class Closing { stay, consume };
  /// The closing bracket is missing at `at`; `before` is where the last part ended. Says how to continue, or throws.
  Closing not_closed(std::uint32_t before, std::uint32_t at);
  bool without_block() { return std::exchange(block_may_follow_, false); }
  void set_block_may_follow(bool may) { block_may_follow_ = may; }
  void deeper(std::uint32_t at);
  void shallower() { --depth_; }

  // Literals, operators and constructs whose parts need further checks
  void number(std::uint32_t begin, std::uint32_t end);
  void color(std::uint32_t begin, std::uint32_t end);
  void plus_sign(std::uint32_t begin, std::uint32_t end);
  void infix_symbol(std::uint32_t begin, std::uint32_t end);
  void infix_word(std::uint32_t begin, std::uint32_t end);
  void close_block(std::uint32_t end);
  void close_list(std::uint32_t end);
  void close_record(std::uint32_t end);
  void close_if(std::uint32_t end);
  void close_param(std::uint32_t end);
  void close_expect(std::uint32_t end);

  /// Records and continues; throws SyntaxError if there are too many.
  void report(Diagnostic diagnostic);
  void complain(Complaint complaint, std::uint32_t begin, std::uint32_t end);
  [[noreturn]] void fail(Expected expected, std::uint32_t at);
  Span span(std::uint32_t begin, std::uint32_t end) const { return {file, begin, end}; }

  /// What must be restored after an error in an item.
  struct Checkpoint {
    AstBuilder::Snapshot build;
    std::size_t open;
    Modes modes;
    int depth;
    std::size_t blocks;
    std::uint32_t item;
    bool follows_line;
  };
  Checkpoint begin_item(std::uint32_t at);
  /// An item that only repeats an earlier one is not parsed; returns where it ends.
  std::optional<std::uint32_t> repeat_item(std::uint32_t begin) { return folder_.repeat_item(text, begin); }
  void finish_item(const Checkpoint& checkpoint);
  /// Replaces the item by an error node; returns where to continue.
  std::uint32_t replace_item(const Checkpoint& checkpoint, std::uint32_t begin, const SyntaxError& error);
  void too_deep(std::uint32_t begin, std::uint32_t end);

  /// The item is the first in a block of what POV-Ray has, too, and a value without a name: `plane { y, 0 }`.
  bool begins_with_bare_value() const;

private:
  SyntaxPlace place(std::uint32_t at) const { return {text, file, at, item_, item_follows_line_, open_}; }
  void add(Diagnostic diagnostic);
  [[noreturn]] void fail_at_end();
  void leave_item(const Checkpoint& checkpoint);
  bool begins_foreign_vector(std::uint32_t at) const;

  RepeatFolder folder_;
  std::vector<OpenBracket> open_;
  bool newline_is_space_ = false;
  bool block_may_follow_ = true;
  bool follows_line_ = false; ///< the last separator was a newline
  bool item_follows_line_ = false;
  bool is_at_end_ = false; ///< unclosed brackets at the end of the file have been reported
  int depth_ = 0;
  std::uint32_t item_ = 0;
};

} // namespace rt::lang
