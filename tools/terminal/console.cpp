#include "tools/terminal/console.hpp"

#include "renderer/image/file.hpp"

#include <unistd.h>

#include <cstdlib>
#include <exception>

namespace rt::tools {

void print(std::string_view text) {
  write_all(STDOUT_FILENO, text, "standard output");
}

void print_error(std::string_view text) noexcept {
  try {
    write_all(STDERR_FILENO, text, "standard error");
  } catch (const std::exception&) {
  }
}

bool error_is_terminal() {
  return ::isatty(STDERR_FILENO) != 0;
}

bool terminal_takes_color() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  if (no_color != nullptr && *no_color != '\0') return false;
  if (terminal == nullptr) return false;
  const std::string_view name = terminal;
  return name != "dumb" && !name.starts_with("vt1") && !name.starts_with("vt2");
}

bool error_takes_color() {
  return error_is_terminal() && terminal_takes_color();
}

bool output_takes_color() {
  return ::isatty(STDOUT_FILENO) != 0 && terminal_takes_color();
}

} // namespace rt::tools
