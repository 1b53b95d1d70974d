#include "tests/support/program.hpp"

#include "tests/paths.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

namespace rt::tests {
namespace {

using Clock = std::chrono::steady_clock;

void require(bool is_fine, const char* what) {
  if (!is_fine) throw std::system_error(errno, std::generic_category(), what);
}

struct Pipe {
  int read_end = -1, write_end = -1;
  Pipe() {
    std::array<int, 2> ends{};
    require(::pipe2(ends.data(), O_CLOEXEC) == 0, "pipe");
    read_end = ends[0];
    write_end = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_read();
    close_write();
  }
  void close_read() { close_one(read_end); }
  void close_write() { close_one(write_end); }

private:
  static void close_one(int& file) {
    if (file >= 0) ::close(file);
    file = -1;
  }
};

/// Puts a terminal in the place of a pipe: what the program writes to its one end is read from the other.
void make_terminal(Pipe& pipe) {
  pipe.close_read();
  pipe.close_write();
  winsize size{24, 80, 0, 0};
  require(::openpty(&pipe.read_end, &pipe.write_end, nullptr, nullptr, &size) == 0, "openpty");
  ::fcntl(pipe.read_end, F_SETFD, FD_CLOEXEC);
  ::fcntl(pipe.write_end, F_SETFD, FD_CLOEXEC);
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> list;
  for (std::string& s : strings) list.push_back(s.data());
  list.push_back(nullptr);
  return list;
}

/// In the child: becomes the program. Only calls that are allowed after a fork.
[[noreturn]] void become(int program, const RunOptions& options, char* const* arguments, char* const* environment,
                         int in, int out, int err) {
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (options.greatest_file) {
    const rlimit limit{*options.greatest_file, *options.greatest_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_IGN); // so that writing fails, instead of killing
  }
  const bool is_ready = ::chdir(options.folder.c_str()) == 0;
  if (options.as_nobody && ::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(126);
  if (is_ready) ::fexecve(program, arguments, environment);
  ::_exit(127);
}

// Before it becomes the program, the process has the handlers of this one.
bool listens_to(pid_t process, int signal) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/" + std::to_string(process) + "/exe", error);
  if (error || program == std::filesystem::read_symlink("/proc/self/exe", error)) return false;
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigCgt:")) return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
  return false;
}

/// Feeds and reads a running program.
class Conversation {
public:
  Conversation(pid_t process, const RunOptions& options, Pipe& in, Pipe& out, Pipe& err)
      : process_(process), options_(options), in_(in), out_(out), err_(err) {
    ::fcntl(in_.write_end, F_SETFL, O_NONBLOCK);
    if (options_.input.empty()) in_.close_write();
    if (options_.closes_output) out_.close_read();
  }

  Outcome to_the_end() {
    int status = 0;
    while (true) {
      exchange();
      act();
      const pid_t ended = ::waitpid(process_, &status, WNOHANG);
      if (ended == process_) break;
    }
    while (exchange()) {
    }
    if (was_sent_)
      outcome_.since_signal = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - sent_at_);
    if (WIFEXITED(status))
      outcome_.exit_code = WEXITSTATUS(status);
    else
      outcome_.signal = WTERMSIG(status);
    return outcome_;
  }

private:
  /// Moves what is there to be moved, waiting for it a short time; false if there was nothing.
  bool exchange() {
    std::array<pollfd, 3> files{
        pollfd{in_.write_end, POLLOUT, 0}, {out_.read_end, POLLIN, 0}, {err_.read_end, POLLIN, 0}};
    if (::poll(files.data(), files.size(), 5) <= 0) return false;
    bool moved = false;
    if (files[0].revents != 0) moved |= feed();
    if (files[1].revents != 0) moved |= take(out_, outcome_.output);
    if (files[2].revents != 0) moved |= take(err_, outcome_.errors);
    return moved;
  }
  bool feed() {
    const ssize_t n = ::write(in_.write_end, options_.input.data() + fed_, options_.input.size() - fed_);
    if (n > 0) fed_ += static_cast<std::size_t>(n);
    if ((n < 0 && errno != EAGAIN) || fed_ == options_.input.size()) in_.close_write();
    return n > 0;
  }
  static bool take(Pipe& pipe, std::string& text) {
    std::array<char, 1 << 16> block;
    const ssize_t n = ::read(pipe.read_end, block.data(), block.size());
    if (n <= 0) { // a terminal whose other end is closed fails to be read
      pipe.close_read();
      return false;
    }
    text.append(block.data(), static_cast<std::size_t>(n));
    return true;
  }
  void act() {
    const auto now = Clock::now();
    if (options_.signal && !was_sent_) {
      if (!listens_since_ && listens_to(process_, *options_.signal)) listens_since_ = now;
      const bool has_said_it = outcome_.errors.find(options_.signal_after) != std::string::npos;
      if (has_said_it && listens_since_ && now - *listens_since_ >= options_.signal_delay) {
        ::kill(process_, *options_.signal);
        was_sent_ = true;
        sent_at_ = now;
      }
    }
    if (now - start_ > options_.time_limit) ::kill(process_, SIGKILL);
  }

  pid_t process_;
  const RunOptions& options_;
  Pipe& in_;
  Pipe& out_;
  Pipe& err_;
  Outcome outcome_;
  std::size_t fed_ = 0;
  Clock::time_point start_ = Clock::now(), sent_at_;
  std::optional<Clock::time_point> listens_since_;
  bool was_sent_ = false;
};

} // namespace

TestFolder::TestFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "rtlang-test-XXXXXX").string();
  require(::mkdtemp(name.data()) != nullptr, "mkdtemp");
  path_ = name;
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void TestFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
}

std::string TestFolder::read(const std::string& name) const {
  std::ostringstream text;
  text << std::ifstream(path_ / name, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::string> TestFolder::names() const {
  std::vector<std::string> list;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) list.push_back(entry.path().filename().string());
  std::sort(list.begin(), list.end());
  return list;
}

Outcome run_program(const std::string& program, const std::vector<std::string>& arguments, const RunOptions& options) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = options.environment;
  for (const std::string variable :
       {"PATH=/usr/local/bin:/usr/bin:/bin", "HOME=/nonexistent", "LC_ALL=C.UTF-8", "TERM=xterm"}) {
    const std::string name = variable.substr(0, variable.find('=') + 1);
    if (std::none_of(environment.begin(), environment.end(),
                     [&](const auto& given) { return given.starts_with(name); }))
      environment.push_back(variable);
  }
  // What the thread sanitizer is told counts for the program too.
  if (const char* options_of_sanitizer = std::getenv("TSAN_OPTIONS"))
    environment.push_back(std::string("TSAN_OPTIONS=") + options_of_sanitizer);
  const std::vector<char*> argument_list = pointers(words), environment_list = pointers(environment);
  // Opened now: who gives up root's rights may no longer reach it.
  const int file = ::open(program.c_str(), O_RDONLY | O_CLOEXEC);
  require(file >= 0, program.c_str());
  Pipe in, out, err;
  if (options.error_is_terminal) make_terminal(err);

  std::signal(SIGPIPE, SIG_IGN); // a program need not read all of its input
  const pid_t process = ::fork();
  require(process >= 0, "fork");
  if (process == 0) {
    std::signal(SIGPIPE, SIG_DFL);
    become(file, options, argument_list.data(), environment_list.data(), in.read_end, out.write_end, err.write_end);
  }
  ::close(file);
  in.close_read();
  out.close_write();
  err.close_write();
  return Conversation(process, options, in, out, err).to_the_end();
}

Outcome rtlang(const std::vector<std::string>& arguments, const RunOptions& options) {
  return run_program(RTLANG_BINARY, arguments, options);
}

} // namespace rt::tests
