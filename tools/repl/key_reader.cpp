#include "tools/repl/key_reader.hpp"

#include "lang/text/utf8.hpp"
#include "tools/terminal/terminal.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>

namespace rt::tools {
namespace {

constexpr int escape_timeout_ms = 40; // within which the rest of an escape sequence arrives
constexpr int paste_timeout_ms = 2000;
constexpr std::string_view paste_begin = "\x1b[200~", paste_end = "\x1b[201~";

std::size_t length_of_utf8(unsigned char first) {
  if (first < 0xc0) return 1;
  return first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

// The length of a terminal's reply, ESC [ ? numbers c, at the beginning of the text.
std::size_t length_of_answer(std::string_view text) {
  if (text.substr(0, 3) != "\x1b[?") return 0;
  const std::size_t end = text.find_first_not_of("0123456789;", 3);
  return end != std::string_view::npos && text[end] == 'c' ? end + 1 : 0;
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

} // namespace

KeyReader::KeyReader(int wake_fd) : wake_fd_(wake_fd) {
  detail::listen_to_terminal_signals();
}
KeyReader::~KeyReader() {
  detail::restore_terminal_signals();
}

bool KeyReader::has_more() const {
  int waiting = 0;
  return !bytes_.empty() || (ioctl(STDIN_FILENO, FIONREAD, &waiting) == 0 && waiting > 0);
}

std::string KeyReader::ask(std::string_view question, char last) {
  constexpr int patience_ms = 150;
  if (::write(STDOUT_FILENO, question.data(), question.size()) < 0) return "";
  do {
    const std::size_t begin = bytes_.find("\x1b[?");
    const std::size_t end = begin == std::string::npos ? begin : bytes_.find(last, begin);
    if (end == std::string::npos) continue;
    const std::string answer = bytes_.substr(begin, end - begin + 1);
    bytes_.erase(begin, end - begin + 1);
    return answer;
  } while (fill(patience_ms));
  return "";
}

bool KeyReader::fill(int timeout_ms) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (poll(&input, 1, timeout_ms) <= 0) return false;
  std::array<char, 4096> buffer;
  const ssize_t n = ::read(STDIN_FILENO, buffer.data(), buffer.size());
  if (n > 0)
    bytes_.append(buffer.data(), static_cast<std::size_t>(n));
  else if (n == 0 || (errno != EINTR && errno != EAGAIN))
    is_at_end_ = true;
  return n > 0;
}

Key KeyReader::read() {
  while (true) {
    if (!bytes_.empty()) return decode();
    if (is_at_end_) return {.kind = Key::Kind::end};
    std::array<pollfd, 3> sources{
        {{detail::signal_pipe(), POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}, {wake_fd_, POLLIN, 0}}};
    if (poll(sources.data(), sources.size(), -1) < 0) continue; // a signal: its byte is in the pipe
    if (sources[0].revents & POLLIN) {
      char event = 0;
      if (::read(detail::signal_pipe(), &event, 1) == 1)
        return {.kind = event == 'I' ? Key::Kind::interrupt : Key::Kind::resize};
    }
    if (sources[1].revents != 0)
      fill(0);
    else if (sources[2].revents & POLLIN)
      return {.kind = Key::Kind::wake};
  }
}

Key KeyReader::decode() {
  if (bytes_[0] == '\x1b') return escape();
  const std::size_t wanted = length_of_utf8(static_cast<unsigned char>(bytes_[0]));
  while (bytes_.size() < wanted && fill(escape_timeout_ms)) {
  }
  const lang::Character c = lang::decode(bytes_);
  bytes_.erase(0, c.bytes);
  return {.code = c.code_point};
}

Key KeyReader::escape() {
  struct Sequence {
    std::string_view bytes;
    Key::Kind kind;
  };
  if (const std::size_t answer = length_of_answer(bytes_); answer > 0) { // one that arrived too late
    bytes_.erase(0, answer);
    return {.kind = Key::Kind::nothing};
  }
  static constexpr std::array<Sequence, 7> known{{{"\x1b[A", Key::Kind::up},
                                                  {"\x1bOA", Key::Kind::up},
                                                  {"\x1b[B", Key::Kind::down},
                                                  {"\x1bOB", Key::Kind::down},
                                                  {"\x1b\r", Key::Kind::new_row},
                                                  {"\x1b\n", Key::Kind::new_row},
                                                  {paste_begin, Key::Kind::paste}}};
  while (true) {
    bool may_become_known = false;
    for (const Sequence& sequence : known) {
      if (starts_with(bytes_, sequence.bytes)) {
        bytes_.erase(0, sequence.bytes.size());
        return sequence.kind == Key::Kind::paste ? paste() : Key{.kind = sequence.kind};
      }
      may_become_known = may_become_known || starts_with(sequence.bytes, bytes_);
    }
    if (!may_become_known || !fill(escape_timeout_ms)) break;
  }
  const char first = bytes_[0];
  bytes_.erase(0, 1);
  return {.code = static_cast<unsigned char>(first)};
}

Key KeyReader::paste() {
  std::size_t end;
  while ((end = bytes_.find(paste_end)) == std::string::npos && fill(paste_timeout_ms)) {
  }
  Key key{.kind = Key::Kind::paste, .text = bytes_.substr(0, end)};
  bytes_.erase(0, end == std::string::npos ? end : end + paste_end.size());
  // Terminals send the newlines of pasted text as Enter.
  std::string text;
  for (std::size_t i = 0; i < key.text.size(); ++i) {
    if (key.text[i] == '\t')
      text += "  "; // libedit would show it with the wrong width
    else if (key.text[i] != '\r')
      text += key.text[i];
    else if (i + 1 == key.text.size() || key.text[i + 1] != '\n')
      text += '\n';
  }
  key.text = std::move(text);
  return key;
}

} // namespace rt::tools
