#include "tools/povray/run/process.hpp"

#include "renderer/image/file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace rt::tools {
namespace {

constexpr const char* errors_file = ".errors";

// What the child needs, prepared before the fork: between fork and exec nothing may allocate.
struct Launch {
  std::string program, folder, errors, home;
  std::vector<std::string> arguments;
  std::vector<char*> argv;
  std::vector<char*> environment;
};

Launch prepare(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& folder) {
  Launch launch{
      program.string(), folder.string(), (folder / errors_file).string(), "HOME=" + folder.string(), arguments, {}, {}};
  launch.argv.push_back(launch.program.data());
  for (std::string& argument : launch.arguments) launch.argv.push_back(argument.data());
  launch.argv.push_back(nullptr);
  launch.environment = {launch.home.data(), nullptr};
  return launch;
}

[[noreturn]] void become(const Launch& launch, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int none = open("/dev/null", O_RDWR | O_CLOEXEC);
  const int errors = open(launch.errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  const bool is_ready = getppid() == parent && none >= 0 && errors >= 0 && chdir(launch.folder.c_str()) == 0 &&
                        dup2(none, 0) >= 0 && dup2(none, 1) >= 0 && dup2(errors, 2) >= 0;
  if (is_ready) execve(launch.program.c_str(), launch.argv.data(), launch.environment.data());
  _exit(127);
}

// Sleeps until the process ends, but not for long: a stop from outside must be noticed. Polling every few milliseconds
// costs more than POV-Ray itself if many run concurrently.
class ProcessEnd {
public:
  explicit ProcessEnd(pid_t process) : file_(static_cast<int>(syscall(SYS_pidfd_open, process, 0))) {}
  ~ProcessEnd() {
    if (file_ >= 0) close(file_);
  }
  ProcessEnd(const ProcessEnd&) = delete;
  ProcessEnd& operator=(const ProcessEnd&) = delete;

  void wait_a_while() const {
    constexpr int while_running = 100, without_files = 5; // milliseconds; kernels before 5.3 have no pidfd
    pollfd file{file_, POLLIN, 0};
    poll(&file, file_ >= 0 ? 1 : 0, file_ >= 0 ? while_running : without_files);
  }

private:
  int file_;
};

} // namespace

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "rtlang-XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw std::filesystem::filesystem_error("cannot make a scratch folder", name,
                                            std::error_code(errno, std::generic_category()));
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path ? path : "/usr/local/bin:/usr/bin:/bin";
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    const std::filesystem::path candidate = std::filesystem::path(folder) / name;
    if (!folder.empty() && std::filesystem::is_regular_file(candidate) && access(candidate.c_str(), X_OK) == 0)
      return std::filesystem::absolute(candidate);
  }
  return {};
}

ProcessResult run_process(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, std::chrono::milliseconds limit,
                          const std::atomic<bool>* stop) {
  const Launch launch = prepare(program, arguments, folder);
  const pid_t self = getpid();
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot start " + launch.program);
  if (child == 0) become(launch, self);

  ProcessResult result;
  const ProcessEnd end(child);
  const auto deadline = std::chrono::steady_clock::now() + limit;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    result.stopped = stop && *stop;
    result.timed_out = std::chrono::steady_clock::now() > deadline;
    if (result.stopped || result.timed_out) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      break;
    }
    end.wait_a_while();
  }
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  std::error_code error;
  if (std::filesystem::exists(launch.errors, error)) result.errors = read_file(launch.errors);
  return result;
}

} // namespace rt::tools
