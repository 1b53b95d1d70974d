#include "lang/check/files.hpp"

#include "lang/syntax/parse.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <system_error>

namespace rt::lang {

namespace fs = std::filesystem;

namespace {

fs::path resolved(const fs::path& path) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(path, error);
  return error ? fs::absolute(path).lexically_normal() : whole;
}

bool is_within(const fs::path& path, const fs::path& folder) {
  const auto [in_folder, in_path] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  // A folder written with a slash at its end has an empty last part.
  return in_folder == folder.end() || (std::next(in_folder) == folder.end() && in_folder->empty());
}

// The ending, which most files share, does not make names alike: `a.rtl` is no slip for `b.rtl`.
bool is_like(const std::string& name, const std::string& other) {
  const std::string stem = fs::path(name).stem().string(), other_stem = fs::path(other).stem().string();
  const std::string_view candidates[] = {other_stem};
  return stem == other_stem || nearest(stem, candidates);
}

} // namespace

std::string read_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw std::system_error(EISDIR, std::generic_category(), path.string());
  constexpr std::uintmax_t most = 0xffff'ffff; // places in a text are 32-bit numbers
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::system_error(errno, std::generic_category(), path.string());
  std::string text;
  const auto size = fs::file_size(path, error);
  if (!error && size > most) throw std::system_error(EFBIG, std::generic_category(), path.string());
  if (!error) text.reserve(size);
  char buffer[1 << 16];
  while (in.read(buffer, sizeof buffer) || in.gcount() > 0) text.append(buffer, static_cast<std::size_t>(in.gcount()));
  if (text.size() > most) throw std::system_error(EFBIG, std::generic_category(), path.string());
  if (in.bad()) throw std::system_error(EIO, std::generic_category(), path.string());
  return text;
}

Files::Files(Program& program, Report& report, const fs::path& folder, const std::vector<std::string>& roots)
    : program_(program), report_(report), folder_(resolved(folder.empty() ? fs::path(".") : folder)) {
  for (const std::string& root : roots) roots_.push_back(resolved(root));
}

void Files::set_folder(const fs::path& folder) {
  folder_ = resolved(folder);
}

Unit& Files::parse_text(std::string name, std::string path, std::string text, Span included_from) {
  const auto start = std::chrono::steady_clock::now();
  bytes_ += text.size();
  const FileId file = program_.sources.add(std::move(name), std::move(path), std::move(text), included_from);
  ParseOptions options;
  options.folds_repeats = true;
  Parsed parsed = parse(program_.sources, file, program_.symbols, options);
  report_.take(std::move(parsed.diagnostics));
  Unit& unit = program_.units.emplace_back();
  unit.ast = std::move(parsed.ast);
  parse_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return unit;
}

Unit& Files::parse_expression_text(std::string name, std::string text) {
  const FileId file = program_.sources.add(std::move(name), {}, std::move(text));
  Parsed parsed = parse_expression(program_.sources, file, program_.symbols);
  report_.take(std::move(parsed.diagnostics));
  Unit& unit = program_.units.emplace_back();
  unit.ast = std::move(parsed.ast);
  return unit;
}

bool Files::is_allowed(const fs::path& path) const {
  return is_within(path, folder_) ||
         std::ranges::any_of(roots_, [&](const fs::path& root) { return is_within(path, root); });
}

fs::path Files::find(std::string_view path, Span place) {
  const std::string& from = program_.sources.file(place.file).path;
  const fs::path base = from.empty() ? folder_ : fs::path(from).parent_path();
  fs::path found = resolved(base / path);
  std::error_code error;
  if (!fs::exists(found, error)) {
    for (const fs::path& root : roots_) {
      const fs::path other = resolved(root / path);
      if (fs::exists(other, error)) found = other;
    }
  }
  if (is_allowed(found)) return found;
  if (Diagnostic* d = report_.error("E0603", place)) {
    d->message = "this file is outside of the scene's folder";
    const bool is_absolute = fs::path(path).is_absolute();
    d->label =
        fmt::format("this leads to {}", is_absolute ? found.string() : found.lexically_relative(folder_).string());
    d->notes.push_back({std::nullopt, "files are read from the folder of the scene, and from the folders in it"});
    d->notes.push_back({std::nullopt, "`--include-root FOLDER` on the command line allows another folder"});
  }
  return {};
}

// Relative to the scene's folder, as the scene itself names it.
std::string Files::display_name(const fs::path& path) const {
  return is_within(path, folder_) ? path.lexically_relative(folder_).string() : path.string();
}

std::string Files::like_named(const fs::path& path, Span place) const {
  const fs::path folder = path.parent_path();
  if (!is_allowed(folder)) return {};
  const std::string name = path.filename().string();
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    // Neither what a link leads to outside nor the file that asks can be what was meant.
    const fs::path other = resolved(entry->path());
    const bool is_file = is_allowed(other) && entry->is_regular_file(error);
    if (!is_file || other == program_.sources.file(place.file).path) continue;
    if (std::string other_name = entry->path().filename().string(); is_like(name, other_name))
      names.push_back(std::move(other_name));
  }
  std::ranges::sort(names); // a folder has no order
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  return std::string(nearest(name, candidates).value_or(""));
}

Unit* Files::read(const fs::path& path, Span place) {
  std::string text;
  try {
    std::error_code error;
    // To open a pipe would wait for whoever writes to it.
    if (fs::is_fifo(path, error)) throw std::system_error(EINVAL, std::generic_category(), path.string());
    text = read_file(path);
  } catch (const std::system_error& failure) {
    if (Diagnostic* d = report_.error("E0601", place)) {
      d->message = "this file cannot be read";
      d->label = fmt::format("{}: {}", display_name(path), failure.code().message());
      const bool is_missing = failure.code() == std::errc::no_such_file_or_directory;
      if (const std::string guess = is_missing ? like_named(path, place) : ""; !guess.empty())
        d->label += fmt::format("; did you mean `{}`?", guess);
    }
    return nullptr;
  }
  return &parse_text(display_name(path), path.string(), std::move(text), place);
}

} // namespace rt::lang
