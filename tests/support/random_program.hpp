#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace rt::tests {

/// Writes programs that parse, in every construct of the grammar and with every freedom of layout: blank lines,
/// comments, separators, line breaks where they are allowed. Names need not be known: only the syntax is right.
class RandomProgram {
public:
  explicit RandomProgram(std::uint32_t seed) : random_(seed) {}

  /// Begins with a blank line, which no formatted text does.
  std::string text(int items);

private:
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }
  bool chance(int percent) { return below(100) < percent; }
  std::string pick(std::initializer_list<const char*> words);
  std::string comment() { return "c" + std::to_string(++comments_); }

  std::string gap();          ///< may be empty
  std::string space();        ///< at least one blank
  std::string continuation(); ///< behind an operator: may break the line
  std::string separator(bool is_list);
  std::string item(int depth);
  std::string thing(int depth);
  std::string block(int depth, bool is_value = false);
  std::string expression(int depth);
  std::string operand(int depth);
  std::string on_lines(int depth); ///< an expression in brackets where line breaks count
  std::string list(int depth);
  std::string comprehension(int depth);
  std::string call(int depth);
  std::string parameters(int depth);
  std::string choice(int depth, bool is_value);
  std::string loop(int depth);
  std::string name() { return pick({"a", "b", "radius", "wood", "sphere", "x1", "format", "_y", "let"}); }
  std::string literal();

  std::mt19937 random_;
  int comments_ = 0;
  int parentheses_ = 0; ///< 0: a line break ends what stands before it
};

} // namespace rt::tests
