#pragma once

#include <string>
#include <string_view>

namespace rt::tools {

/// One thing that happened at the terminal.
struct Key {
  enum class Kind {
    character, ///< `code`; control characters too, and escape sequences other than those below one byte at a time
    up,
    down,      ///< arrows
    new_row,   ///< Alt and Enter
    paste,     ///< `text`, of a terminal that marks what is pasted
    interrupt, ///< Ctrl-C
    end,       ///< the terminal is gone
    resize,
    nothing,
    wake, ///< the descriptor given to the reader is readable
  };
  Kind kind = Kind::character;
  char32_t code = 0;
  std::string text = {};
};

/// Reads keys from standard input, a terminal that does not wait for whole lines. While it exists SIGINT and SIGWINCH
/// are its events (`InterruptScope` overrules it for a time).
class KeyReader {
public:
  explicit KeyReader(int wake_fd);
  ~KeyReader();
  KeyReader(const KeyReader&) = delete;
  KeyReader& operator=(const KeyReader&) = delete;

  /// Waits for the next.
  Key read();
  /// Writes a question to the terminal and gives its answer, from ESC [ ? to `last`; empty where none comes in time.
  /// What is typed meanwhile is kept.
  std::string ask(std::string_view question, char last);
  /// Whether more was typed than was read so far.
  bool has_more() const;

private:
  bool fill(int timeout_ms); // false where nothing came
  Key decode();
  Key escape();
  Key paste();

  int wake_fd_;
  std::string bytes_; // read and not yet decoded
  bool is_at_end_ = false;
};

} // namespace rt::tools
