#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Running the real program, as its users do, without any shell.
namespace rt::tests {

/// A new folder for a test, removed with all that is in it.
class TestFolder {
public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const; ///< "" for a file that is not there
  std::vector<std::string> names() const;          ///< of the files in it, sorted

private:
  std::filesystem::path path_;
};

struct RunOptions {
  std::filesystem::path folder = "/"; ///< the working folder
  std::string input;                  ///< for its standard input
  std::vector<std::string> environment;
  bool error_is_terminal = false;           ///< 80 columns, TERM=xterm
  bool closes_output = false;               ///< nobody reads its standard output
  bool as_nobody = false;                   ///< without root's rights, where the test has them
  std::optional<std::size_t> greatest_file; ///< bytes; what goes beyond fails, as on a full disk
  /// Sent as soon as the program listens to it, after `signal_delay` more.
  std::optional<int> signal;
  std::chrono::milliseconds signal_delay{0};
  std::string signal_after;            ///< and not before this stands in what it wrote to standard error
  std::chrono::seconds time_limit{60}; ///< then it is killed
};

struct Outcome {
  int exit_code = -1; ///< -1 if a signal ended it
  int signal = 0;
  std::string output, errors;
  std::chrono::milliseconds since_signal{0}; ///< how long it went on after the signal was sent
};

/// Runs a program to its end. Throws std::system_error if it cannot be started.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const RunOptions& options = {});
/// The same for rtlang.
Outcome rtlang(const std::vector<std::string>& arguments, const RunOptions& options = {});

} // namespace rt::tests
