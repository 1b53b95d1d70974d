#include "lang/check/lint/rules.hpp"

#include "lang/text/suggest.hpp"
#include "lang/text/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace rt::lang {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// Which rules are suppressed where.
class Permissions {
public:
  explicit Permissions(const SourceMap& sources) : sources_(sources) {
    for (FileId file = 0; file < sources.size(); ++file) {
      if (sources.file(file).text.find("lint:") != std::string::npos) read_file(file);
    }
  }

  bool allow(const Diagnostic& d) const {
    if (on_files_.contains({d.span.file, d.code})) return true;
    const bool is_about_all = d.span.begin == d.span.end;
    return !is_about_all &&
           on_lines_.contains({d.span.file, sources_.position(d.span.file, d.span.begin).line, d.code});
  }

  std::vector<Diagnostic> take_mistakes() { return std::move(mistakes_); }

private:
  struct Wanted {
    std::vector<std::string_view> codes;
    bool is_for_file = false;
  };

  void read_file(FileId file) {
    const std::string_view text = sources_.file(file).text;
    std::vector<std::string_view> pending; // of comments that stand alone: for the next line with code
    std::uint32_t code_line = 0;           // the last one
    Token token{};
    for (std::uint32_t at = 0; (token = next_token(text, at)).kind != TokenKind::end; at = token.end) {
      if (token.kind == TokenKind::newline) continue;
      const std::uint32_t line = sources_.position(file, token.begin).line;
      if (token.kind != TokenKind::line_comment && token.kind != TokenKind::block_comment) {
        if (line != code_line) {
          for (const std::string_view code : pending) on_lines_.emplace(file, line, code);
          pending.clear();
          code_line = line;
        }
        continue;
      }
      const Wanted wanted = read_comment({file, token.begin, token.end});
      for (const std::string_view code : wanted.codes) {
        if (wanted.is_for_file)
          on_files_.emplace(file, code);
        else if (line == code_line)
          on_lines_.emplace(file, line, code);
        else
          pending.push_back(code);
      }
    }
  }

  // "// lint: allow hidden, W0206 in this file: a reason"
  Wanted read_comment(Span span) {
    Wanted wanted;
    const std::string_view whole = sources_.text(span);
    std::string_view text = trim(whole.substr(2));
    if (text.ends_with("*/")) text.remove_suffix(2);
    constexpr std::string_view mark = "lint:", verb = "allow", everywhere = "in this file";
    if (!text.starts_with(mark)) return wanted;
    text = trim(text.substr(mark.size()));
    if (!text.starts_with(verb)) {
      complain(span, "a lint comment is `lint: allow NAME`", "write `// lint: allow NAME`");
      return wanted;
    }
    text = trim(text.substr(verb.size()));
    text = trim(text.substr(0, text.find(':')));
    if (text.ends_with(everywhere)) {
      wanted.is_for_file = true;
      text = trim(text.substr(0, text.size() - everywhere.size()));
    }
    if (text.empty()) complain(span, "this comment does not name a lint rule", "write `// lint: allow NAME`");
    while (!text.empty()) {
      const std::size_t end = std::min(text.find_first_of(", \t"), text.size());
      const std::string_view word = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      if (word.empty()) continue;
      if (const LintRule* rule = find_lint_rule(word)) {
        wanted.codes.push_back(rule->code);
        continue;
      }
      const auto begin =
          static_cast<std::uint32_t>(span.begin + static_cast<std::uint32_t>(word.data() - whole.data()));
      std::vector<std::string_view> names;
      for (const LintRule& rule : lint_rules()) names.push_back(rule.name);
      const auto guess = nearest(word, names);
      complain({span.file, begin, static_cast<std::uint32_t>(begin + word.size())},
               fmt::format("there is no lint rule `{}`", word),
               guess ? fmt::format("did you mean `{}`?", *guess) : "`rtlang lint --rules` lists them");
    }
    return wanted;
  }

  void complain(Span span, std::string message, std::string label) {
    Diagnostic& d = mistakes_.emplace_back();
    d.severity = Severity::warning;
    d.code = lint_rule::unknown_rule.code;
    d.message = std::move(message);
    d.label = std::move(label);
    d.span = span;
  }

  const SourceMap& sources_;
  std::set<std::tuple<FileId, std::uint32_t, std::string>> on_lines_;
  std::set<std::pair<FileId, std::string>> on_files_;
  std::vector<Diagnostic> mistakes_;
};

} // namespace

std::span<const LintRule> lint_rules() {
  static constexpr LintRule table[] = {
      lint_rule::unknown_rule,     lint_rule::never_placed,  lint_rule::never_used,
      lint_rule::unused_parameter, lint_rule::radians,       lint_rule::hides_noun,
      lint_rule::no_ior,           lint_rule::camera_inside, lint_rule::light_inside,
      lint_rule::nothing_in_view,  lint_rule::behind_camera, lint_rule::coincident,
      lint_rule::too_small,        lint_rule::hidden,        lint_rule::overlapping_media,
      lint_rule::nearly_flat,      lint_rule::dark_light,    lint_rule::black_picture,
      lint_rule::clipped_picture,  lint_rule::depth_reached};
  return table;
}

const LintRule* find_lint_rule(std::string_view word) {
  for (const LintRule& rule : lint_rules()) {
    if (rule.code == word || rule.name == word) return &rule;
  }
  return nullptr;
}

std::string lint_rules_markdown() {
  std::string text = "| code | name | what it warns of |\n|---|---|---|\n";
  for (const LintRule& rule : lint_rules()) {
    const auto code = find_code(rule.code);
    text += fmt::format("| {} | `{}` | {} |\n", rule.code, rule.name, code ? code->title : "");
  }
  return text;
}

std::vector<Diagnostic> without_allowed(std::vector<Diagnostic> found, const SourceMap& sources,
                                        std::span<const std::string> allowed) {
  Permissions permissions(sources);
  for (Diagnostic& mistake : permissions.take_mistakes()) found.push_back(std::move(mistake));
  std::erase_if(found, [&](const Diagnostic& d) {
    const LintRule* rule = find_lint_rule(d.code);
    const bool is_allowed =
        std::ranges::any_of(allowed, [&](const std::string& word) { return rule && find_lint_rule(word) == rule; });
    return is_allowed || permissions.allow(d);
  });
  const auto place = [](const Diagnostic& d) {
    return std::tuple(d.span.begin == d.span.end, d.span.file, d.span.begin, d.span.end);
  };
  std::ranges::stable_sort(found, {}, place);
  return found;
}

} // namespace rt::lang
