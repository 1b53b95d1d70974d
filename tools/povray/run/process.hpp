#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt::tools {

/// A new folder in the system's folder for temporary files, removed with all its contents.
class ScratchFolder {
public:
  /// Throws std::filesystem::filesystem_error if it cannot be created.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// The executable of a program found in PATH; empty if there is none.
std::filesystem::path find_program(const std::string& name);

struct ProcessResult {
  int exit_code = -1;     ///< negative: the number of the signal that ended it
  bool timed_out = false; ///< it was killed
  bool stopped = false;   ///< it was killed because `stop` was set
  std::string errors;     ///< what it wrote to standard error
};

/// Runs a program without a shell, with `folder` as its working and home folder, no input, and its output discarded;
/// waits for it, and kills it after `limit` or when `stop` is set. It dies with the calling thread.
ProcessResult run_process(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, std::chrono::milliseconds limit,
                          const std::atomic<bool>* stop = nullptr);

} // namespace rt::tools
