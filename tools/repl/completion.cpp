#include "tools/repl/completion.hpp"

#include "lang/ide/complete.hpp"
#include "tools/repl/commands.hpp"
#include "tools/repl/shell.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace rt::tools {
namespace {

namespace fs = std::filesystem;

Completion beginning_with(std::string_view start, std::size_t begin, std::vector<std::string> words) {
  std::erase_if(words, [&](const std::string& word) { return word.compare(0, start.size(), start) != 0; });
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return {begin, std::move(words)};
}

Completion statement(Shell& shell, std::string_view text, std::size_t cursor) {
  lang::WordCompletion found = lang::complete(shell.session(), text, cursor);
  if (!found.is_path) return {found.begin, std::move(found.words)};
  std::vector<std::string> paths =
      complete_path(text.substr(found.begin, cursor - found.begin), shell.session().folder());
  std::erase_if(paths, [](const std::string& path) { return !path.ends_with('/') && !path.ends_with(".rtl"); });
  return {found.begin, std::move(paths)};
}

// NAME.property, where the second part is among the properties of the first.
Completion property(Shell& shell, std::string_view start, std::size_t begin) {
  const std::size_t dot = start.find('.');
  if (dot == std::string_view::npos) return beginning_with(start, begin, shell.session().names());
  return beginning_with(start.substr(dot + 1), begin + dot + 1, shell.session().properties_of(start.substr(0, dot)));
}

Completion argument(Shell& shell, const ShellCommand& command, std::string_view text, std::size_t arguments_begin,
                    std::size_t cursor) {
  const std::size_t space = text.substr(0, cursor).find_last_of(" \t\n");
  const std::size_t begin = space == std::string_view::npos ? arguments_begin : std::max(arguments_begin, space + 1);
  const std::string_view start = text.substr(begin, cursor - begin);
  switch (command.argument) {
  case ArgumentKind::none:
    return {};
  case ArgumentKind::file:
    return {begin, complete_path(start, ".")};
  case ArgumentKind::thing:
    return beginning_with(start, begin, shell.session().names());
  case ArgumentKind::word:
    return beginning_with(start, begin, lang::documented_words(shell.session()));
  case ArgumentKind::command: {
    std::vector<std::string> names;
    for (const ShellCommand& other : shell_commands()) names.emplace_back(other.name);
    return beginning_with(start, begin, std::move(names));
  }
  case ArgumentKind::property:
    if (begin == arguments_begin) return property(shell, start, begin);
    [[fallthrough]];
  case ArgumentKind::statement: {
    Completion found = statement(shell, text.substr(arguments_begin), cursor - arguments_begin);
    found.begin += arguments_begin;
    return found;
  }
  }
  return {};
}

} // namespace

std::vector<std::string> complete_path(std::string_view start, const std::string& base) {
  const std::size_t slash = start.rfind('/');
  const std::string folder(slash == std::string_view::npos ? "" : start.substr(0, slash + 1));
  fs::path place = fs::path(base) / folder;
  if (const char* home = std::getenv("HOME"); home && folder.starts_with("~/")) place = home + folder.substr(1);
  const std::string_view name = start.substr(folder.size());
  std::vector<std::string> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(place, error)) {
    const std::string file = entry.path().filename().string();
    if (file.compare(0, name.size(), name) != 0 || (file.starts_with('.') && !name.starts_with('.'))) continue;
    std::error_code ignored;
    found.push_back(folder + file + (entry.is_directory(ignored) ? "/" : ""));
  }
  std::sort(found.begin(), found.end());
  return found;
}

Completion complete(Shell& shell, std::string_view text, std::size_t cursor) {
  if (!is_command(text)) return statement(shell, text, cursor);
  const std::size_t colon = text.find(':');
  const CommandLine line = split_command(text);
  const std::size_t word_begin = colon + 1, word_end = word_begin + line.word.size();
  if (cursor < word_begin) return {};
  const std::vector<ShellCommand> commands = shell_commands();
  if (cursor <= word_end) {
    std::vector<std::string> names;
    for (const ShellCommand& command : commands) names.emplace_back(command.name);
    return beginning_with(text.substr(word_begin, cursor - word_begin), word_begin, std::move(names));
  }
  const CommandChoice choice = choose_command(line.word, commands);
  if (!choice.command) return {};
  const std::size_t begin = text.find_first_not_of(" \t\n", word_end);
  return argument(shell, *choice.command, text, std::min(begin, cursor), cursor);
}

} // namespace rt::tools
