#pragma once

#include <ctime>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tools {

/// The folder for data that outlives a run: $XDG_STATE_HOME/rtlang or ~/.local/state/rtlang, created if necessary;
/// empty if neither is available.
std::string state_folder();

/// The inputs of a session, in a file of its own from which the session can be recovered if the program was killed.
/// Entries are written at once; the file is locked as long as its session lives. If the file cannot be written the
/// session continues without it.
class Journal {
public:
  /// `folder` empty: no journal. The file is created with the first entry.
  explicit Journal(std::string folder);
  /// Leaves the file.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  void add(std::string_view entry);
  /// Deletes all entries, and the file. `base` (unless empty) is the entry that restores the state from which the next
  /// ones start; it is written together with them.
  void clear(std::string base = {});

private:
  void open();

  std::string folder_, path_, base_;
  int fd_ = -1;
};

/// A journal that no running session owns.
struct AbandonedSession {
  std::string path;
  std::string working_folder; ///< what relative paths in it are resolved against
  std::time_t time = 0;       ///< of the last entry
  std::vector<std::string> entries;
};

/// Those in the folder, latest first; all but the nine latest are deleted.
std::vector<AbandonedSession> find_abandoned_sessions(const std::string& folder);

} // namespace rt::tools
