#include "tools/repl/commands.hpp"

#include "lang/text/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rt::tools {

std::vector<ShellCommand> shell_commands() {
  std::vector<ShellCommand> all;
  for (const auto table : {picture_commands(), document_commands(), question_commands(), general_commands()})
    all.insert(all.end(), table.begin(), table.end());
  return all;
}

CommandChoice choose_command(std::string_view word, std::span<const ShellCommand> commands) {
  if (word.empty()) return {nullptr, "a colon begins a command; :help lists them"};
  std::vector<const ShellCommand*> found;
  for (const ShellCommand& command : commands) {
    if (command.name == word) return {&command, ""};
    if (command.name.substr(0, word.size()) == word) found.push_back(&command);
  }
  if (found.size() == 1) return {found.front(), ""};
  if (found.size() > 1) {
    std::vector<std::string> names;
    for (const ShellCommand* command : found) names.push_back(fmt::format(":{}", command->name));
    return {nullptr, fmt::format("`:{}` could be {}", word, fmt::join(names, ", "))};
  }
  std::vector<std::string_view> names;
  for (const ShellCommand& command : commands) names.push_back(command.name);
  const auto nearest = lang::nearest(word, names);
  if (nearest) return {nullptr, fmt::format("unknown command `:{}`; did you mean `:{}`?", word, *nearest)};
  return {nullptr, fmt::format("unknown command `:{}`; :help lists the commands", word)};
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view spaces = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(spaces);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(spaces) - begin + 1);
}

bool is_command(std::string_view input) {
  return trimmed(input).starts_with(':');
}

CommandLine split_command(std::string_view input) {
  std::string_view rest = trimmed(input);
  rest.remove_prefix(1);
  std::size_t end = 0;
  while (end < rest.size() && (std::isalnum(static_cast<unsigned char>(rest[end])) != 0 || rest[end] == '_')) ++end;
  return {rest.substr(0, end), trimmed(rest.substr(end))};
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  bool in_word = false, in_quotes = false;
  for (const char c : text) {
    if (c == '"') {
      in_quotes = !in_quotes;
      if (!in_word) words.emplace_back();
      in_word = true;
    } else if (!in_quotes && (c == ' ' || c == '\t' || c == '\n')) {
      in_word = false;
    } else {
      if (!in_word) words.emplace_back();
      in_word = true;
      words.back() += c;
    }
  }
  return words;
}

} // namespace rt::tools
