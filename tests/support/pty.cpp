#include "tests/support/pty.hpp"

#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace rt::tests {
namespace {

using Clock = std::chrono::steady_clock;

std::size_t length_of_utf8(char first) {
  const auto c = static_cast<unsigned char>(first);
  return c < 0xc0 ? 1 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : 4;
}

winsize make_size(int columns, int rows) {
  winsize size{};
  size.ws_col = static_cast<unsigned short>(columns);
  size.ws_row = static_cast<unsigned short>(rows);
  return size;
}

} // namespace

Screen::Screen(int columns, int rows)
    : columns_(columns), rows_(rows),
      cells_(static_cast<std::size_t>(rows), std::vector<std::string>(static_cast<std::size_t>(columns), " ")) {}

void Screen::write(std::string_view bytes) {
  pending_ += bytes;
  std::string_view rest = pending_;
  while (!rest.empty()) {
    std::size_t used = 1;
    switch (rest[0]) {
    case '\r':
      x_ = 0;
      break;
    case '\n':
      new_line();
      break;
    case '\b':
      x_ = std::max(0, x_ - 1);
      break;
    case '\t':
      x_ = std::min(columns_ - 1, (x_ / 8 + 1) * 8);
      break;
    case '\a':
    case '\0': // padding, for terminals that take their time
      break;
    case '\x1b':
      used = sequence(rest);
      break;
    default:
      used = length_of_utf8(rest[0]);
      if (used > rest.size())
        used = 0;
      else
        put(std::string(rest.substr(0, used)));
    }
    if (used == 0) break;
    rest.remove_prefix(used);
  }
  pending_ = std::string(rest);
}

void Screen::put(std::string character) {
  if (x_ >= columns_) {
    x_ = 0;
    new_line();
  }
  cells_[static_cast<std::size_t>(y_)][static_cast<std::size_t>(x_++)] = std::move(character);
}

void Screen::new_line() {
  if (++y_ < rows_) return;
  y_ = rows_ - 1;
  std::rotate(cells_.begin(), cells_.begin() + 1, cells_.end());
  erase(y_, 0, columns_);
}

void Screen::erase(int y, int from, int to) {
  for (int x = from; x < to; ++x) cells_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = " ";
}

std::size_t Screen::sequence(std::string_view bytes) {
  if (bytes.size() < 2) return 0;
  if (bytes[1] == '_' || bytes[1] == 'P' || bytes[1] == ']') { // pictures, titles: up to ESC \ or BEL
    const std::size_t end = bytes.find("\x1b\\", 2), bell = bytes.find('\a', 2);
    if (end == std::string_view::npos && bell == std::string_view::npos) return 0;
    return bell < end ? bell + 1 : end + 2;
  }
  if (bytes[1] == 'M') y_ = std::max(0, y_ - 1); // reverse index
  if (bytes[1] != '[') return 2;
  std::vector<int> numbers{0};
  for (std::size_t i = 2; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (c >= '0' && c <= '9')
      numbers.back() = numbers.back() * 10 + (c - '0');
    else if (c == ';')
      numbers.push_back(0);
    else if (c >= '@' && c <= '~') {
      if (bytes[2] != '?') control(c, numbers);
      return i + 1;
    }
  }
  return 0;
}

void Screen::control(char final, const std::vector<int>& numbers) {
  const int n = std::max(1, numbers[0]);
  auto& row = cells_[static_cast<std::size_t>(y_)];
  const auto here = row.begin() + std::min(x_, columns_ - 1);
  const int room = std::max(0, columns_ - x_);
  switch (final) {
  case 'A':
    y_ = std::max(0, y_ - n);
    break;
  case 'B':
    y_ = std::min(rows_ - 1, y_ + n);
    break;
  case 'C':
    x_ = std::min(columns_ - 1, x_ + n);
    break;
  case 'D':
    x_ = std::max(0, x_ - n);
    break;
  case 'G':
    x_ = std::min(columns_, n) - 1;
    break;
  case 'H':
    y_ = std::min(rows_, n) - 1;
    x_ = std::min(columns_, std::max(1, numbers.size() > 1 ? numbers[1] : 1)) - 1;
    break;
  case 'J':
    if (numbers[0] == 2) {
      for (int y = 0; y < rows_; ++y) erase(y, 0, columns_);
    } else {
      erase(y_, x_, columns_);
      for (int y = y_ + 1; y < rows_; ++y) erase(y, 0, columns_);
    }
    break;
  case 'K':
    numbers[0] == 1 ? erase(y_, 0, x_ + 1) : erase(y_, numbers[0] == 2 ? 0 : x_, columns_);
    break;
  case 'P':
    std::rotate(here, here + std::min(n, room), row.end());
    erase(y_, columns_ - std::min(n, room), columns_);
    break;
  case '@':
    std::rotate(here, row.end() - std::min(n, room), row.end());
    erase(y_, x_, x_ + std::min(n, room));
    break;
  default:
    break; // colours and modes
  }
}

std::string Screen::row(int y) const {
  std::string text;
  for (const std::string& cell : cells_[static_cast<std::size_t>(y)]) text += cell;
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string Screen::text() const {
  std::string all;
  for (int y = 0; y < rows_; ++y) all += row(y) + "\n";
  return all.substr(0, all.find_last_not_of('\n') + 1) + "\n";
}

Pty::Pty(const std::vector<std::string>& command, const Environment& environment, int columns, int rows)
    : screen_(columns, rows) {
  winsize size = make_size(columns, rows);
  child_ = forkpty(&terminal_, nullptr, nullptr, &size);
  if (child_ < 0) throw std::runtime_error("cannot make a pseudo-terminal");
  if (child_ == 0) {
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    execv(words[0], words.data());
    _exit(127);
  }
}

Pty::~Pty() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  hang_up();
}

void Pty::send(std::string_view keys) {
  while (!keys.empty()) {
    const ssize_t n = ::write(terminal_, keys.data(), keys.size());
    if (n <= 0) throw std::runtime_error("the program does not take what is typed");
    keys.remove_prefix(static_cast<std::size_t>(n));
  }
}

bool Pty::read(std::chrono::milliseconds patience) {
  pollfd source{terminal_, POLLIN, 0};
  if (poll(&source, 1, static_cast<int>(patience.count())) <= 0) return false;
  std::array<char, 8192> buffer;
  const ssize_t n = ::read(terminal_, buffer.data(), buffer.size());
  if (n <= 0) return false; // EIO once the program has ended
  const std::string_view bytes(buffer.data(), static_cast<std::size_t>(n));
  output_ += bytes;
  screen_.write(bytes);
  return true;
}

bool Pty::wait_for(std::string_view text, std::chrono::milliseconds patience) {
  const Clock::time_point deadline = Clock::now() + patience;
  while (screen_.text().find(text) == std::string::npos) {
    if (Clock::now() > deadline) return false;
    read(std::chrono::milliseconds(50));
  }
  return true;
}

bool Pty::wait_for_cursor_row(std::string_view row, std::chrono::milliseconds patience) {
  const Clock::time_point deadline = Clock::now() + patience;
  while (true) {
    if (!read(std::chrono::milliseconds(50)) && screen_.cursor_row() == row) return true;
    if (Clock::now() > deadline) return false;
  }
}

bool Pty::wait_for_cursor_row(std::string_view row, int column, std::chrono::milliseconds patience) {
  const Clock::time_point deadline = Clock::now() + patience;
  while (!wait_for_cursor_row(row, std::chrono::milliseconds(100)) || screen_.cursor_x() != column)
    if (Clock::now() > deadline) return false;
  return true;
}

int Pty::wait_for_end(std::chrono::milliseconds patience) {
  const Clock::time_point deadline = Clock::now() + patience;
  while (Clock::now() < deadline) {
    read(std::chrono::milliseconds(20));
    int status = 0;
    if (waitpid(child_, &status, WNOHANG) != child_) continue;
    while (read(std::chrono::milliseconds(0))) {
    }
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return -1;
}

void Pty::signal(int number) const {
  kill(child_, number);
}

void Pty::hang_up() {
  if (terminal_ >= 0) close(terminal_);
  terminal_ = -1;
}

void Pty::resize(int columns, int rows) {
  const winsize size = make_size(columns, rows);
  ioctl(terminal_, TIOCSWINSZ, &size);
  screen_ = Screen(columns, rows);
}

} // namespace rt::tests
