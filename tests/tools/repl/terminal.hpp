#pragma once

#include "tests/paths.hpp"
#include "tests/support/pty.hpp"

#include <catch2/catch.hpp>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The real program at a terminal of its own.
namespace rt::tests {

inline constexpr std::string_view prompt = "rtl>";

/// A home that outlives one run of the program.
struct Home {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("rtlang_repl_test_" + std::to_string(getpid()));
  Home() {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~Home() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return (path / name).string(); }
};

class Terminal : public Pty {
public:
  explicit Terminal(const Home& home, std::vector<std::string> arguments = {}, int columns = 80, int rows = 24,
                    Environment environment = {})
      : Pty(command(std::move(arguments)), with_defaults(home, std::move(environment)), columns, rows) {
    REQUIRE(wait_for_cursor_row(prompt));
  }
  /// Types a line, and waits until the next one is asked for.
  void say(const std::string& line) {
    send(line + enter);
    INFO(screen().text());
    REQUIRE(wait_for_cursor_row(prompt));
  }
  /// Types what does not end a line, and waits for what the line is then.
  void type(const std::string& keys, const std::string& row) {
    send(keys);
    INFO(screen().text());
    REQUIRE(wait_for_cursor_row(row));
  }
  bool shows(std::string_view text) {
    UNSCOPED_INFO(screen().text());
    return wait_for(text, std::chrono::seconds(5));
  }
  /// All that stands on the screen below the banner.
  std::string below_banner() const {
    const std::string text = screen().text();
    return text.substr(text.find('\n') + 1);
  }

private:
  static Environment with_defaults(const Home& home, Environment added) {
    Environment environment{{"XDG_STATE_HOME", home.path.string()},
                            {"TERM", "xterm-256color"},
                            {"NO_COLOR", "1"},
                            {"RTLANG_GRAPHICS", "blocks"}};
    environment.insert(environment.end(), added.begin(), added.end());
    return environment;
  }
  static std::vector<std::string> command(std::vector<std::string> arguments) {
    std::vector<std::string> all{RTLANG_BINARY};
    if (!arguments.empty()) all.push_back("repl");
    all.insert(all.end(), arguments.begin(), arguments.end());
    return all;
  }
};

} // namespace rt::tests
