#pragma once

#include <ctime>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tools {

/// Where the program keeps what outlives a run: $XDG_STATE_HOME/rtlang or ~/.local/state/rtlang, made if need be; empty
/// where neither can be had.
std::string state_folder();

/// What was typed into a session, entry by entry, in a file of its own from which the session can be had again when the
/// program was killed. Entries are written at once; the file is locked as long as its session lives. Where the file
/// cannot be written the session goes on without.
class Journal {
public:
  /// `folder` empty: no journal. The file is made with the first entry.
  explicit Journal(std::string folder);
  /// Leaves the file.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  void add(std::string_view entry);
  /// Forgets all entries, and the file. `base` (unless empty) is the entry that leads to where the next ones start
  /// from; it is written when they are.
  void clear(std::string base = {});

private:
  void open();

  std::string folder_, path_, base_;
  int fd_ = -1;
};

/// A journal that no session holds any more.
struct AbandonedSession {
  std::string path;
  std::string working_folder; ///< what relative paths in it start from
  std::time_t time = 0;       ///< of the last entry
  std::vector<std::string> entries;
};

/// Those in the folder, the latest first; all but the nine latest are deleted.
std::vector<AbandonedSession> find_abandoned_sessions(const std::string& folder);

} // namespace rt::tools
