#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Programs driven through a pseudo-terminal, as a person at a terminal would.
namespace rt::tests {

/// What a terminal shows: enough of one to read what a line editor draws (cursor movements, erasing, inserting; colours
/// and pictures in other protocols are passed over).
class Screen {
public:
  Screen(int columns, int rows);
  void write(std::string_view bytes);

  /// A row without the spaces at its end; and all rows down to the last that is not empty.
  std::string row(int y) const;
  std::string text() const;
  int cursor_x() const { return x_; }
  int cursor_y() const { return y_; }
  std::string cursor_row() const { return row(y_); }

private:
  void put(std::string character);
  void new_line();
  std::size_t sequence(std::string_view bytes); // its length, 0 if it is not whole yet
  void control(char final, const std::vector<int>& numbers);
  void erase(int y, int from, int to);

  int columns_, rows_;
  int x_ = 0, y_ = 0;
  std::vector<std::vector<std::string>> cells_;
  std::string pending_;
};

/// A program with a terminal of its own.
class Pty {
public:
  using Environment = std::vector<std::pair<std::string, std::string>>;
  /// The environment is added to this process's.
  Pty(const std::vector<std::string>& command, const Environment& environment, int columns = 80, int rows = 24);
  ~Pty();
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  void send(std::string_view keys);
  /// Waits until the screen's text holds `text`; false after the time has run out.
  bool wait_for(std::string_view text, std::chrono::milliseconds patience = std::chrono::seconds(20));
  /// Waits until the row with the cursor is `row` and nothing more comes.
  bool wait_for_cursor_row(std::string_view row, std::chrono::milliseconds patience = std::chrono::seconds(20));
  /// The same, and until the cursor stands in that column: a row does not show the spaces at its end.
  bool wait_for_cursor_row(std::string_view row, int column,
                           std::chrono::milliseconds patience = std::chrono::seconds(20));
  /// The exit code once the program has ended (128 and more after a signal), -1 when it has not.
  int wait_for_end(std::chrono::milliseconds patience = std::chrono::seconds(20));

  void signal(int number) const;
  /// As when the window is closed.
  void hang_up();
  void resize(int columns, int rows);

  const Screen& screen() const { return screen_; }
  const std::string& output() const { return output_; } ///< all that was written, escape sequences too

private:
  bool read(std::chrono::milliseconds patience);

  pid_t child_ = -1;
  int terminal_ = -1;
  Screen screen_;
  std::string output_;
};

inline constexpr char ctrl_c = '\x03', ctrl_d = '\x04', tab = '\t', enter = '\r';
inline constexpr std::string_view arrow_up = "\x1b[A", arrow_down = "\x1b[B", arrow_left = "\x1b[D";

} // namespace rt::tests
