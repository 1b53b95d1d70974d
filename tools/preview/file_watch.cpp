#include "tools/preview/file_watch.hpp"

#include <system_error>

namespace rt::tools::preview {

namespace fs = std::filesystem;

std::optional<FileWatch::Stamp> FileWatch::stamp_of(const fs::path& file) {
  std::error_code error;
  Stamp stamp;
  stamp.time = fs::last_write_time(file, error);
  if (error) return std::nullopt;
  stamp.size = fs::file_size(file, error);
  return error ? std::nullopt : std::optional(stamp);
}

void FileWatch::follow(std::vector<fs::path> files) {
  files_.clear();
  for (fs::path& file : files) {
    const auto stamp = stamp_of(file);
    files_.push_back({std::move(file), stamp});
  }
  gone_since_.reset();
}

bool FileWatch::has_changed(Clock::time_point now) {
  bool is_different = false, is_gone = false;
  for (const Followed& file : files_) {
    const auto stamp = stamp_of(file.path);
    if (stamp == file.stamp) continue;
    is_different = true;
    is_gone = is_gone || !stamp || stamp->size == 0;
  }
  if (!is_gone) gone_since_.reset();
  if (is_gone && !gone_since_) gone_since_ = now;
  if (!is_different || (is_gone && now - *gone_since_ < std::chrono::milliseconds(300))) return false;
  for (Followed& file : files_) file.stamp = stamp_of(file.path);
  gone_since_.reset();
  return true;
}

} // namespace rt::tools::preview
