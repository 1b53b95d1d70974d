#pragma once

#include "lang/session/session.hpp"
#include "tools/live/session_scene.hpp"
#include "tools/repl/journal.hpp"
#include "tools/terminal/picture.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rt::tools {

/// The output of a session.
struct ShellOutput {
  std::function<void(std::string_view)> print;    ///< answers
  std::function<void(std::string_view)> complain; ///< diagnostics and errors
  bool uses_color = false;
};

struct ShellOptions {
  lang::LoadOptions load;
  std::string folder;          ///< what relative includes are resolved against
  std::string journal_folder;  ///< empty: no journal
  bool is_interactive = false; ///< a person is typing: informal messages are welcome
  bool moves_cursor = false;   ///< on a terminal where earlier output can be overwritten
};

/// A session with its commands: takes complete inputs and answers them, without reading keys or knowing anything about
/// the terminal but its size.
class Shell {
public:
  Shell(const ShellOptions& options, ShellOutput output);

  /// Statements, or a command that begins with a colon. False if it failed, which has been reported.
  bool run(std::string_view input);
  bool wants_to_quit() const { return wants_to_quit_; }

  /// Reports the camera and light that were assumed, once for each state of the scene.
  void report_assumptions();

  // For the commands.
  lang::Session& session() { return session_; }
  live::SessionScene& scene() { return scene_; }
  const ShellOptions& options() const { return options_; }
  PicturePrinter& printer() { return printer_; }
  const ShellOutput& output() const { return output_; }
  void print(std::string_view text) const { output_.print(text); }
  /// Prints an error and returns false.
  bool fail(std::string_view text) const;
  /// Reports the result of an input; false unless it was accepted.
  bool report(const lang::SessionResult& result);
  void quit() { wants_to_quit_ = true; }

  bool shows_previews() const { return shows_previews_; }
  void set_previews(bool shows) { shows_previews_ = shows; }
  /// Whether the picture has changed since the last call.
  bool take_change() { return std::exchange(has_changed_, false); }

  /// The file that `:save` without a name writes to; empty if there is none yet.
  const std::string& path() const { return path_; }
  /// The document is now identical to the file.
  void became_saved(const std::string& path);
  bool has_unsaved_changes() const { return session_.version() != saved_version_ && !session_.is_empty(); }

  /// The sessions that were not saved, latest first.
  const std::vector<AbandonedSession>& abandoned() const { return abandoned_; }
  /// Runs the inputs of one of them, numbered from 1.
  bool recover(std::size_t number);
  /// To be called at the end: a session that is saved or empty needs no journal.
  void close();

  double last_seconds() const { return last_seconds_; }

private:
  bool run_statements(std::string_view input);
  void remember(std::string_view input);

  ShellOptions options_;
  ShellOutput output_;
  lang::Session session_;
  live::SessionScene scene_;
  PicturePrinter printer_;
  Journal journal_;
  std::vector<AbandonedSession> abandoned_;
  std::string path_;
  std::size_t saved_version_ = 0;
  double last_seconds_ = 0;
  bool wants_to_quit_ = false;
  bool shows_previews_ = false;
  bool has_changed_ = false;
  std::optional<std::size_t> reported_version_;
  std::size_t journaled_version_ = 0; // the version that the journal restores
};

} // namespace rt::tools
