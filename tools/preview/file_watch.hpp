#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

namespace rt::tools::preview {

/// Notices when files are saved, however an editor does it: in place, by renaming a new file to the old name, on a
/// network drive. It polls; for so few files that costs nothing.
class FileWatch {
public:
  using Clock = std::chrono::steady_clock;

  /// From now on these files, in their current state.
  void follow(std::vector<std::filesystem::path> files);

  /// Whether one of them has changed since this last returned true. A file that is missing or empty is most likely
  /// being written: that counts once it has been so for 300 ms.
  bool has_changed(Clock::time_point now = Clock::now());

private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  static std::optional<Stamp> stamp_of(const std::filesystem::path& file);

  struct Followed {
    std::filesystem::path path;
    std::optional<Stamp> stamp; ///< none: it is missing
  };
  std::vector<Followed> files_;
  std::optional<Clock::time_point> gone_since_;
};

} // namespace rt::tools::preview
