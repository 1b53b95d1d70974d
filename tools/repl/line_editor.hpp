#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tools {

/// The possible completions of the word before the cursor.
struct Completion {
  std::size_t begin = 0;          ///< where that word begins in the text, in bytes
  std::vector<std::string> words; ///< whole words, in the order in which they are shown
};

/// The editor's callbacks while a line is typed.
struct LineEditorHooks {
  /// Whether Enter accepts the text; otherwise it starts a new line of it.
  std::function<bool(std::string_view text)> is_complete;
  std::function<Completion(std::string_view text, std::size_t cursor)> complete;
  /// Before every key.
  std::function<void()> on_key;
  /// When `wake_fd` (-1: none) becomes readable while the editor waits for a key: reads from it, and returns what to
  /// write above the prompt.
  int wake_fd = -1;
  std::function<std::string()> on_wake;
};

/// Lines typed at a terminal, edited with the usual keys, with history and completion; a line may be several rows of
/// text. At most one editor may exist at a time: libedit's readline interface keeps its state in globals.
class LineEditor {
public:
  enum class End { line, interrupted, end_of_input };
  struct Line {
    End end = End::line;
    std::string text; ///< without the final newline
  };

  /// Takes over standard input and output, which must be a terminal. History is read from `history_path` (empty: none)
  /// and each line is appended as soon as it is accepted, so that a killed program loses none.
  LineEditor(LineEditorHooks hooks, std::string history_path);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// Queries the terminal (see `KeyReader::ask`).
  std::string ask(std::string_view question, char last);

  /// `prompt` may contain escape sequences for colour (ESC [ … m).
  Line read(std::string_view prompt);

private:
  class Keys;
  std::unique_ptr<Keys> keys_;
  std::string history_path_;
};

} // namespace rt::tools
