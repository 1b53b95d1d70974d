#include "renderer/image/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace rt {
namespace {

[[noreturn]] void fail(int error, std::string_view action, const std::string& path) {
  throw std::system_error(error, std::generic_category(), fmt::format("cannot {} `{}`", action, path));
}

/// An open file that is closed at the end of its scope.
class Descriptor {
public:
  explicit Descriptor(int file) : file_(file) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (file_ >= 0) ::close(file_);
  }
  int get() const { return file_; }
  /// Closes it now and returns an error number, or 0: a full disk may only be reported here.
  int close() {
    const int file = file_;
    file_ = -1;
    return ::close(file) == 0 ? 0 : errno;
  }

private:
  int file_;
};

/// A new file beside `target`, removed again unless it was renamed to it.
class Temporary {
public:
  explicit Temporary(std::filesystem::path target) : target_(std::move(target)), file_(create()) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  Descriptor& file() { return file_; }
  /// Renames it to the target. Returns an error number, or 0.
  int rename_to_target() {
    if (::rename(path_.c_str(), target_.c_str()) != 0) return errno;
    path_.clear();
    return 0;
  }

private:
  int create() {
    // The name is kept short enough for file systems with names of 255 bytes.
    const std::string name = target_.filename().string().substr(0, 200);
    for (int i = 0;; ++i) {
      path_ = (target_.parent_path() / fmt::format(".{}.{}-{}.tmp", name, ::getpid(), i)).string();
      const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file >= 0) return file;
      if (errno != EEXIST) {
        const int error = errno;
        path_.clear();
        fail(error, "write", target_.string());
      }
    }
  }

  std::filesystem::path target_;
  std::string path_;
  Descriptor file_;
};

void write_directly(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (file.get() < 0) fail(errno, "write", path);
  write_all(file.get(), bytes, path);
  if (const int error = file.close()) fail(error, "write", path);
}

} // namespace

std::string read_file(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) fail(errno, "read", path);
  struct stat status {};
  if (::fstat(file.get(), &status) == 0 && S_ISDIR(status.st_mode)) fail(EISDIR, "read", path);
  std::string bytes;
  bytes.resize(status.st_size > 0 ? static_cast<std::size_t>(status.st_size) + 1 : 65536);
  std::size_t size = 0;
  while (true) {
    if (size == bytes.size()) bytes.resize(2 * size);
    const ssize_t n = ::read(file.get(), bytes.data() + size, bytes.size() - size);
    if (n == 0) break;
    if (n < 0 && errno != EINTR) fail(errno, "read", path);
    if (n > 0) size += static_cast<std::size_t>(n);
  }
  bytes.resize(size);
  return bytes;
}

void write_all(int file, std::string_view bytes, const std::string& name) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR) fail(errno, "write", name);
    if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

namespace {

/// What a path refers to.
struct Target {
  std::filesystem::path path; ///< symbolic links followed
  bool exists;
  bool is_stream; ///< written to directly: a pipe, a device, or any open descriptor of the process
  struct stat status;
};

/// The target of a path that may be written to; throws otherwise.
Target writable_target(const std::string& path) {
  std::error_code no_link;
  Target target{path, false, false, {}};
  target.exists = ::stat(path.c_str(), &target.status) == 0;
  target.is_stream = is_stream(path);
  // The target of a descriptor need not have a path.
  if (!target.is_stream && std::filesystem::is_symlink(target.path, no_link))
    target.path = std::filesystem::weakly_canonical(target.path);
  if (target.exists && S_ISDIR(target.status.st_mode)) fail(EISDIR, "write", path);
  // Renaming would replace even a read-only file.
  if (target.exists && ::access(target.path.c_str(), W_OK) != 0) fail(errno, "write", path);
  if (!target.is_stream) {
    const std::string folder = target.path.has_parent_path() ? target.path.parent_path().string() : ".";
    if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(errno, "write", path);
  }
  return target;
}

} // namespace

bool is_stream(const std::string& path) {
  struct stat status {};
  const bool names_descriptor = path == "/dev/stdout" || path == "/dev/stderr" || path.starts_with("/dev/fd/") ||
                                path.starts_with("/proc/self/fd/");
  return ::stat(path.c_str(), &status) == 0 && (!S_ISREG(status.st_mode) || names_descriptor);
}

void require_writable(const std::string& path) {
  writable_target(path);
}

void replace_file(const std::string& path, std::string_view bytes) {
  const Target target = writable_target(path);
  if (target.is_stream) return write_directly(path, bytes);

  Temporary temporary(target.path);
  const int file = temporary.file().get();
  write_all(file, bytes, path);
  if (target.exists && ::fchmod(file, target.status.st_mode & 07777) != 0) fail(errno, "write", path);
  // Without this a system crash could leave the new name on an empty file.
  if (::fsync(file) != 0 && errno != EINVAL && errno != EROFS) fail(errno, "write", path);
  if (const int error = temporary.file().close()) fail(error, "write", path);
  if (const int error = temporary.rename_to_target()) fail(error, "write", path);
}

} // namespace rt
