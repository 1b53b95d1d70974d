#include "tools/repl/line_editor.hpp"

#include "lang/text/utf8.hpp"
#include "tools/repl/key_reader.hpp"
#include "tools/repl/line_layout.hpp"
#include "tools/terminal/terminal.hpp"

#include <editline/readline.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <optional>
#include <utility>

namespace rt::tools {
namespace {

// Keys that cannot be typed, for actions that we trigger in libedit.
enum PrivateKey : int {
  key_backspace = 0x08,
  key_enter = '\r',
  key_tab = '\t',
  key_interrupt_done = -1,
  key_end_of_line = 0x05,
  key_quote = 0x16, // the next key is inserted as it is, even a newline
  key_up = 0x1c,
  key_down = 0x1d,
  key_newline = 0x1e,
  key_redraw = 0x1f,
  key_clear_screen = 0x0c,
  key_accept = 0x81, // beyond ASCII, but below what libedit inserts as text
  key_previous_entry = 0x82,
  key_next_entry = 0x83,
  key_previous_row = 0x84,
  key_next_row = 0x85,
  key_next_char = 0x86,
  key_kill_line = 0x87,
  key_start_over = 0x88,
};

constexpr std::size_t longest_line = 64 * 1024; // in bytes; a longer text can only be pasted, not edited

void write_all(std::string_view text) {
  std::fflush(stdout);
  while (!text.empty()) {
    const ssize_t n = ::write(STDOUT_FILENO, text.data(), text.size());
    if (n <= 0) return; // the terminal is gone, which the next read reports
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

bool is_on_first_row(std::string_view text, std::size_t cursor) {
  return text.substr(0, cursor).find('\n') == std::string_view::npos;
}
bool is_on_last_row(std::string_view text, std::size_t cursor) {
  return text.substr(cursor).find('\n') == std::string_view::npos;
}

std::string common_start(const std::vector<std::string>& words) {
  std::string start = words.front();
  for (const std::string& word : words) {
    const auto differs = std::mismatch(start.begin(), start.end(), word.begin(), word.end()).first;
    start.erase(differs, start.end());
  }
  return start;
}

// The prompt in libedit's form, with \1 around what has no width, and its width.
struct Prompt {
  std::string marked;
  int width = 0;
};
Prompt mark_invisible(std::string_view prompt) {
  Prompt result;
  for (std::size_t i = 0; i < prompt.size(); ++i) {
    if (prompt[i] != '\x1b') {
      result.marked += prompt[i];
      ++result.width;
      continue;
    }
    const std::size_t end = std::min(prompt.find('m', i), prompt.size() - 1);
    result.marked += '\1';
    result.marked += prompt.substr(i, end - i + 1);
    result.marked += '\1';
    i = end;
  }
  return result;
}

} // namespace

// Feeds libedit: what is typed, with Enter, Tab and the arrows replaced by keys that have the desired effect. libedit's
// callbacks carry no context, hence the one pointer.
class LineEditor::Keys {
public:
  explicit Keys(LineEditorHooks hooks) : hooks_(std::move(hooks)), reader_(hooks_.wake_fd) {
    current = this;
    rl_readline_name = "rtlang";
    rl_catch_signals = 0;
    rl_getc_function = [](FILE*) { return current->next(); };
    rl_initialize();
    bind();
    reserve_bytes();
  }
  ~Keys() { current = nullptr; }

  void begin(int prompt_width) {
    prompt_width_ = prompt_width;
    queue_.clear();
    paste_.reset();
    end_ = End::end_of_input; // unless something else ends it
  }
  End end() const { return end_; }
  KeyReader& reader() { return reader_; }
  std::optional<std::string> take_paste() { return std::exchange(paste_, std::nullopt); }

private:
  static inline Keys* current = nullptr;

  static void bind() {
    rl_add_defun(
        "rtlang-enter", [](int, int) { return current->enter(); }, key_enter);
    rl_add_defun(
        "rtlang-complete", [](int, int) { return current->complete(); }, key_tab);
    rl_add_defun(
        "rtlang-up", [](int, int) { return current->up(); }, key_up);
    rl_add_defun(
        "rtlang-down", [](int, int) { return current->down(); }, key_down);
    rl_add_defun(
        "rtlang-newline", [](int, int) { return rl_insert_text("\n") - 1; }, key_newline);
    rl_add_defun(
        "rtlang-redraw", [](int, int) { return current->redraw(); }, key_redraw);
    for (const int bracket : {'}', ']', ')'})
      rl_add_defun(
          "rtlang-close", [](int, int key) { return current->close(key); }, bracket);
    for (const char* line : {"bind '\\201' ed-newline", "bind '\\202' ed-prev-history", "bind '\\203' ed-next-history",
                             "bind '\\204' ed-prev-line", "bind '\\205' ed-next-line", "bind '\\206' ed-next-char",
                             "bind '\\207' em-kill-line", "bind '\\210' ed-start-over"})
      rl_parse_and_bind(line);
  }

  // libedit keeps a pointer to the line's bytes (`rl_line_buffer`, into which it also writes), and updates it
  // only when the line must grow. But each key may move them: the encoded text is everything that was ever in the
  // line, up to its first NUL. So at first the buffer is filled to its maximum, with the longest characters there
  // are, and then, in an empty line, with so many short ones that it must grow: the address looked up then is
  // final.
  static void reserve_bytes() {
    std::string filler;
    while (filler.size() < 4 * longest_line) filler += "\U0001f642";
    rl_insert_text(filler.c_str());
  }
  void reserve_characters() {
    has_reserved_ = true;
    rl_insert_text(std::string(3 * longest_line, ' ').c_str());
    type(key_start_over);
  }

  std::string_view text() const { return {rl_line_buffer, static_cast<std::size_t>(rl_end)}; }
  std::size_t cursor() const { return static_cast<std::size_t>(rl_point); }

  void type(int key) { queue_.push_back(key); }
  void type_text(std::string_view text) {
    while (!text.empty()) {
      const lang::Character c = lang::decode(text);
      text.remove_prefix(c.bytes);
      if (c.code_point == '\n') {
        begin_row();
        continue;
      }
      if (c.code_point < 0x20) type(key_quote);
      type(static_cast<int>(c.code_point));
    }
  }
  // libedit echoes a newline typed at the line's end like a letter, and from then on believes the cursor to be one row
  // above where it is: the next time it draws the line, the row above appears twice. So the newline is inserted without
  // echo, and a blank that is added and removed makes libedit draw both rows.
  void begin_row() {
    type(key_newline);
    type(' ');
    type(key_backspace);
  }

  int next() {
    if (!has_reserved_) reserve_characters();
    while (queue_.empty()) {
      const Key key = reader_.read();
      if (key.kind != Key::Kind::wake && key.kind != Key::Kind::resize && hooks_.on_key) hooks_.on_key();
      take(key);
    }
    const int key = queue_.front();
    queue_.pop_front();
    return key;
  }

  void take(const Key& key) {
    switch (key.kind) {
    case Key::Kind::character:
      if (static_cast<std::size_t>(rl_end) + 8 > longest_line)
        write_all("\a");
      else
        type(key.code == '\n' ? key_enter : static_cast<int>(key.code));
      break;
    case Key::Kind::up:
      type(key_up);
      break;
    case Key::Kind::down:
      type(key_down);
      break;
    case Key::Kind::new_row:
      type_text("\n");
      break;
    case Key::Kind::paste:
      take_pasted(key.text);
      break;
    case Key::Kind::interrupt:
      end_ = End::interrupted;
      type(key_end_of_line);
      type(key_interrupt_done);
      break;
    case Key::Kind::end:
      type(key_interrupt_done);
      break;
    case Key::Kind::nothing:
      break;
    case Key::Kind::resize:
      rl_resize_terminal();
      type(key_redraw);
      break;
    case Key::Kind::wake:
      wake();
      break;
    }
  }

  // A closing bracket on a row of its own is aligned with what it closes.
  bool closes_row() const {
    if (reader_.has_more() || !queue_.empty()) return false;
    const std::string_view before = text().substr(0, cursor());
    const std::size_t newline = before.rfind('\n');
    if (newline == std::string_view::npos) return false;
    const std::string_view row = before.substr(newline + 1);
    return row.size() >= 2 && row.find_first_not_of(' ') == std::string_view::npos && is_at_end_of_row();
  }
  bool is_at_end_of_row() const { return cursor() == text().size() || text()[cursor()] == '\n'; }

  // What fits on the screen goes into the line, where it can be edited; longer text is accepted as it is.
  void take_pasted(std::string_view pasted) {
    while (!pasted.empty() && (pasted.back() == '\n' || pasted.back() == ' ')) pasted.remove_suffix(1);
    const auto rows = std::count(pasted.begin(), pasted.end(), '\n');
    if (pasted.size() < 4096 && rows + 3 < terminal_size().rows) return type_text(pasted);
    paste_ = std::string(pasted);
    end_ = End::line;
    type(key_end_of_line);
    type(key_interrupt_done);
  }

  void wake() {
    if (!hooks_.on_wake) return;
    above_ = hooks_.on_wake();
    if (!above_.empty()) type(key_redraw);
  }

  // Redraws the prompt and the line, below what is printed above them. Only a function bound to a key knows where the
  // cursor is.
  int redraw() {
    const int rows = rows_above(text().substr(0, cursor()), prompt_width_, terminal_size().columns);
    write_all((rows > 0 ? fmt::format("\x1b[{}A", rows) : "") + "\r\x1b[J" + std::exchange(above_, ""));
    rl_forced_update_display();
    return 0;
  }

  int enter() {
    const std::string_view line = text();
    if (!hooks_.is_complete || hooks_.is_complete(line)) {
      end_ = End::line;
      type(key_accept);
    } else {
      type_text("\n");
      if (!reader_.has_more() && cursor() == line.size()) type_text(indentation_after(line));
    }
    return 0;
  }

  int complete() {
    if (!hooks_.complete) return 0;
    if (reader_.has_more()) { // pasted, or typed by a program: no one waits for a completion
      type_text(" ");
      return 0;
    }
    const Completion found = hooks_.complete(text(), cursor());
    if (found.words.empty()) {
      write_all("\a");
      return 0;
    }
    const std::string start = common_start(found.words);
    const std::size_t typed = cursor() - found.begin;
    if (start.size() > typed) {
      type_text(std::string_view(start).substr(typed));
    } else if (found.words.size() > 1) {
      write_all("\r\n\x1b[J" + in_columns(found.words, static_cast<std::size_t>(terminal_size().columns)));
      rl_forced_update_display();
    }
    return 0;
  }

  int close(int bracket) {
    std::vector<int> keys{key_quote, bracket};
    if (closes_row()) keys = {key_backspace, key_backspace, key_quote, bracket};
    queue_.insert(queue_.begin(), keys.begin(), keys.end()); // before the rest of the pasted text
    return 0;
  }

  int up() {
    type(is_on_first_row(text(), cursor()) ? key_previous_entry : key_previous_row);
    return 0;
  }
  int down() {
    type(is_on_last_row(text(), cursor()) ? key_next_entry : key_next_row);
    return 0;
  }

  LineEditorHooks hooks_;
  KeyReader reader_;
  std::deque<int> queue_;
  int prompt_width_ = 0;
  std::string above_; // what the next redraw prints above the prompt
  bool has_reserved_ = false;
  std::optional<std::string> paste_;
  End end_ = End::end_of_input;
};

LineEditor::LineEditor(LineEditorHooks hooks, std::string history_path)
    : keys_(std::make_unique<Keys>(std::move(hooks))), history_path_(std::move(history_path)) {
  using_history();
  if (history_path_.empty()) return;
  read_history(history_path_.c_str());
  constexpr int most_entries = 5000;
  if (history_length > most_entries) {
    stifle_history(most_entries);
    write_history(history_path_.c_str());
    unstifle_history();
  }
}

LineEditor::~LineEditor() = default;

std::string LineEditor::ask(std::string_view question, char last) {
  return keys_->reader().ask(question, last);
}

LineEditor::Line LineEditor::read(std::string_view prompt) {
  const auto [marked, width] = mark_invisible(prompt);
  keys_->begin(width);
  const BracketedPaste pasting;
  char* typed = readline(marked.c_str());
  Line line{keys_->end(), typed ? typed : ""};
  std::free(typed);
  if (const auto paste = keys_->take_paste()) {
    line.text += *paste;
    write_all(printable(*paste) + "\n");
  }
  if (line.end != End::line) {
    write_all(line.end == End::interrupted ? "^C\r\n" : "\r\n");
    return line;
  }
  const bool is_worth_keeping = line.text.find_first_not_of(" \t\n") != std::string::npos;
  if (is_worth_keeping && line.text.size() < longest_line) {
    const HIST_ENTRY* last = history_length > 0 ? history_get(history_base + history_length - 1) : nullptr;
    if (!last || line.text != last->line) {
      add_history(line.text.c_str());
      if (!history_path_.empty()) append_history(1, history_path_.c_str());
    }
  }
  return line;
}

} // namespace rt::tools
