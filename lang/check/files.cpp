#include "lang/check/files.hpp"

#include "lang/check/errors/statement_errors.hpp"
#include "lang/library/library.hpp"
#include "lang/syntax/parse.hpp"
#include "lang/text/characters.hpp"
#include "lang/text/literals.hpp"
#include "lang/text/stopwatch.hpp"
#include "lang/text/suggest.hpp"
#include "lang/text/tokens.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace rt::lang {

namespace fs = std::filesystem;

namespace {

bool is_within(const fs::path& path, const fs::path& folder) {
  const auto [in_folder, in_path] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  // A folder with a trailing slash has an empty last part.
  return in_folder == folder.end() || (std::next(in_folder) == folder.end() && in_folder->empty());
}

// The extension, which most files share, does not make names similar: `a.rtl` is no typo for `b.rtl`.
bool is_like(const std::string& name, const std::string& other) {
  const std::string stem = fs::path(name).stem().string(), other_stem = fs::path(other).stem().string();
  const std::string_view candidates[] = {other_stem};
  return stem == other_stem || nearest(stem, candidates);
}

} // namespace

Files::Files(Program& program, Report& report, const FileSystem& file_system, const fs::path& folder,
             const std::vector<std::string>& roots)
    : program_(program), report_(report), file_system_(file_system),
      folder_(file_system.canonical(folder.empty() ? "." : folder)) {
  for (const std::string& root : roots) roots_.push_back(file_system_.canonical(root));
}

void Files::set_folder(const fs::path& folder) {
  folder_ = file_system_.canonical(folder);
}

Unit& Files::parse_text(std::string name, std::string path, std::string text, Span included_from) {
  const Stopwatch time;
  bytes_ += text.size();
  const FileId file = program_.sources.add(std::move(name), std::move(path), std::move(text), included_from);
  ParseOptions options;
  options.folds_repeats = folds_repeats_;
  Parsed parsed = parse(program_.sources, file, program_.symbols, options);
  report_.take(std::move(parsed.diagnostics));
  note_division_comments(file);
  Unit& unit = program_.units.emplace_back();
  unit.ast = std::move(parsed.ast);
  parse_seconds_ += time.seconds();
  return unit;
}

void Files::parse_library_and_defines(const std::vector<std::pair<std::string, std::string>>& defines) {
  program_.library = &parse_text(std::string(library_name), {}, std::string(library_text()));
  for (const auto& [name, text] : defines) {
    Unit& unit = parse_expression_text("-D " + name, text);
    program_.defines.push_back({program_.symbols.intern(name), &unit, 0, false});
  }
}

Unit& Files::parse_expression_text(std::string name, std::string text) {
  const FileId file = program_.sources.add(std::move(name), {}, std::move(text));
  Parsed parsed = parse_expression(program_.sources, file, program_.symbols);
  report_.take(std::move(parsed.diagnostics));
  Unit& unit = program_.units.emplace_back();
  unit.ast = std::move(parsed.ast);
  return unit;
}

// `7 // 2`: a number or a name, at most one space, and a comment that is nothing but a number, except for brackets that
// would close those around it.
void Files::note_division_comments(FileId file) {
  const std::string_view text = program_.sources.file(file).text;
  for (std::size_t at = text.find("//"); at != std::string_view::npos; at = text.find("//", at + 2)) {
    const std::string_view rest = text.substr(at + 2, text.find_first_of("\r\n", at) - at - 2);
    std::string_view divisor = rest.substr(0, rest.find_last_not_of(" )]}") + 1);
    if (divisor.starts_with(' ')) divisor.remove_prefix(1);
    if (!begins_number(divisor) || read_number(divisor).length != divisor.size()) continue;
    const std::size_t line = text.substr(0, at).find_last_of('\n') + 1;
    Token last{TokenKind::newline, 0, 0};
    for (Token token = next_token(text, static_cast<std::uint32_t>(line)); token.begin < at;
         token = next_token(text, token.end))
      last = token;
    const bool is_operand =
        last.kind == TokenKind::name || (last.kind == TokenKind::number && is_digit(text[last.end - 1]));
    if (!is_operand || last.end + 1 < at || last.end > at) continue;
    const auto begin = static_cast<std::uint32_t>(at);
    errors::comment_for_division(report_, {file, begin, begin + 2}, program_.sources.position(file, begin).line,
                                 text_of(text, last), divisor);
  }
}

bool Files::is_allowed(const fs::path& path) const {
  return is_within(path, folder_) ||
         std::ranges::any_of(roots_, [&](const fs::path& root) { return is_within(path, root); });
}

fs::path Files::find(std::string_view path, Span place) {
  const std::string& from = program_.sources.file(place.file).path;
  const fs::path base = from.empty() ? folder_ : fs::path(from).parent_path();
  fs::path found = file_system_.canonical(base / path);
  if (!file_system_.exists(found)) {
    for (const fs::path& root : roots_) {
      const fs::path other = file_system_.canonical(root / path);
      if (file_system_.exists(other)) found = other;
    }
  }
  if (is_allowed(found)) return found;
  const bool is_absolute = fs::path(path).is_absolute();
  errors::file_outside_folder(report_, place, is_absolute ? found : found.lexically_relative(folder_));
  return {};
}

// Relative to the scene's folder, as the scene itself refers to it.
std::string Files::display_name(const fs::path& path) const {
  return is_within(path, folder_) ? path.lexically_relative(folder_).string() : path.string();
}

std::string Files::like_named(const fs::path& path, Span place) const {
  const fs::path folder = path.parent_path();
  if (!is_allowed(folder)) return {};
  const std::string name = path.filename().string();
  std::vector<std::string> names;
  for (std::string& other_name : file_system_.files_in(folder)) {
    // Neither the target of a link that leads outside nor the requesting file can have been meant.
    const fs::path other = file_system_.canonical(folder / other_name);
    if (!is_allowed(other) || other == program_.sources.file(place.file).path) continue;
    if (is_like(name, other_name)) names.push_back(std::move(other_name));
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  return std::string(nearest(name, candidates).value_or(""));
}

Unit* Files::read(const fs::path& path, Span place) {
  std::string text;
  try {
    if (file_system_.is_pipe(path)) throw std::system_error(EINVAL, std::generic_category(), path.string());
    text = file_system_.read(path);
  } catch (const std::system_error& failure) {
    const bool is_missing = failure.code() == std::errc::no_such_file_or_directory;
    errors::unreadable_file(report_, place, display_name(path), failure.code().message(),
                            is_missing ? like_named(path, place) : "");
    return nullptr;
  }
  return &parse_text(display_name(path), path.string(), std::move(text), place);
}

} // namespace rt::lang
