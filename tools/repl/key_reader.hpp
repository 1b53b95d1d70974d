#pragma once

#include <string>
#include <string_view>

namespace rt::tools {

/// One event at the terminal.
struct Key {
  enum class Kind {
    character, ///< `code`; also control characters, and escape sequences other than those below one byte at a time
    up,
    down,      ///< arrows
    new_row,   ///< Alt-Enter
    paste,     ///< `text`, from a terminal that brackets pastes
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

/// Reads keys from standard input, a terminal not in line mode. During its lifetime SIGINT and SIGWINCH are its events
/// (`InterruptScope` temporarily overrides it).
class KeyReader {
public:
  explicit KeyReader(int wake_fd);
  ~KeyReader();
  KeyReader(const KeyReader&) = delete;
  KeyReader& operator=(const KeyReader&) = delete;

  /// Waits for the next key.
  Key read();
  /// Sends a query to the terminal and returns its reply, from ESC [ ? to `last`; empty if none arrives in time. What
  /// is typed meanwhile is kept.
  std::string ask(std::string_view question, char last);
  /// Whether more was typed than has been read so far.
  bool has_more() const;

private:
  bool fill(int timeout_ms); // false if nothing arrived
  Key decode();
  Key escape();
  Key paste();

  int wake_fd_;
  std::string bytes_; // read but not yet decoded
  bool is_at_end_ = false;
};

} // namespace rt::tools
