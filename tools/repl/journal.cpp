#include "tools/repl/journal.hpp"

#include "renderer/image/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>

namespace rt::tools {
namespace {

namespace fs = std::filesystem;

// A journal is this line, the working folder, and for each entry its length in bytes, a newline, and the entry with a
// newline. An incomplete entry (the program was killed while writing it) does not count.
constexpr std::string_view header = "rtlang journal 1\n";
constexpr std::string_view extension = ".journal";
constexpr std::size_t most_abandoned = 9;

class Descriptor {
public:
  explicit Descriptor(const std::string& path) : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  bool can_be_locked() const { return fd_ >= 0 && flock(fd_, LOCK_EX | LOCK_NB) == 0; }

private:
  int fd_;
};

std::optional<std::string_view> take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

std::optional<AbandonedSession> parse_journal(std::string_view text) {
  if (text.substr(0, header.size()) != header) return std::nullopt;
  text.remove_prefix(header.size());
  const auto folder = take_line(text);
  if (!folder) return std::nullopt;
  AbandonedSession session;
  session.working_folder = *folder;
  while (const auto line = take_line(text)) {
    std::size_t length = 0;
    const auto parsed = std::from_chars(line->data(), line->data() + line->size(), length);
    if (parsed.ec != std::errc() || length >= text.size()) break;
    session.entries.emplace_back(text.substr(0, length));
    text.remove_prefix(length + 1);
  }
  return session;
}

// Nothing if it cannot be read: another session that starts may have deleted it just now.
std::optional<AbandonedSession> read_journal(const std::string& path) {
  try {
    return parse_journal(read_file(path));
  } catch (const std::system_error&) {
    return std::nullopt;
  }
}

} // namespace

std::string state_folder() {
  fs::path folder;
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state == '/')
    folder = state;
  else if (const char* home = std::getenv("HOME"); home && *home == '/')
    folder = fs::path(home) / ".local/state";
  else
    return "";
  folder /= "rtlang";
  std::error_code error;
  fs::create_directories(folder, error);
  return error ? "" : folder.string();
}

Journal::Journal(std::string folder) : folder_(std::move(folder)) {}

Journal::~Journal() {
  if (fd_ >= 0) ::close(fd_);
}

void Journal::open() {
  path_ = fmt::format("{}/session-{}-{}{}", folder_, std::time(nullptr), getpid(), extension);
  fd_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (fd_ < 0) return;
  flock(fd_, LOCK_EX | LOCK_NB);
  std::error_code error;
  const std::string start = fmt::format("{}{}\n", header, fs::current_path(error).string());
  [[maybe_unused]] const ssize_t n = ::write(fd_, start.data(), start.size());
}

void Journal::add(std::string_view entry) {
  if (folder_.empty()) return;
  const auto record_of = [](std::string_view text) { return fmt::format("{}\n{}\n", text.size(), text); };
  std::string record = record_of(entry);
  if (fd_ < 0) {
    open();
    if (fd_ < 0) return;
    if (!base_.empty()) record = record_of(base_) + record;
  }
  [[maybe_unused]] const ssize_t n = ::write(fd_, record.data(), record.size());
}

void Journal::clear(std::string base) {
  base_ = std::move(base);
  if (fd_ < 0) return;
  ::unlink(path_.c_str());
  ::close(fd_);
  fd_ = -1;
}

std::vector<AbandonedSession> find_abandoned_sessions(const std::string& folder) {
  if (folder.empty()) return {};
  std::vector<AbandonedSession> found;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    const std::string path = file.path().string();
    if (file.path().extension() != extension || !Descriptor(path).can_be_locked()) continue;
    auto session = read_journal(path);
    if (!session || session->entries.empty()) {
      ::unlink(path.c_str());
      continue;
    }
    struct stat status {};
    session->time = stat(path.c_str(), &status) == 0 ? status.st_mtime : 0;
    session->path = path;
    found.push_back(std::move(*session));
  }
  std::sort(found.begin(), found.end(), [](const AbandonedSession& a, const AbandonedSession& b) {
    return a.time != b.time ? a.time > b.time : a.path > b.path;
  });
  for (std::size_t i = most_abandoned; i < found.size(); ++i) ::unlink(found[i].path.c_str());
  found.resize(std::min(found.size(), most_abandoned));
  return found;
}

} // namespace rt::tools
