#pragma once

#include "lang/check/program.hpp"
#include "lang/diagnostics/report.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

/// Reads and parses the files that `include` and `use` name. They are confined to the folder of the scene and what is
/// below it, and to the folders that the command line added; a symbolic link does not lead out.
class Files {
public:
  /// `folder` is where the scene stands; it need not exist when nothing is read from it.
  Files(Program& program, Report& report, const std::filesystem::path& folder, const std::vector<std::string>& roots);

  std::string folder() const { return folder_.string(); }
  /// From now on the scene stands there.
  void set_folder(const std::filesystem::path& folder);

  /// Adds a text to the program and parses it.
  Unit& parse_text(std::string name, std::string path, std::string text, Span included_from = {});
  /// The same for a text that is an expression.
  Unit& parse_expression_text(std::string name, std::string text);

  /// Where the file is that the text at `place` names; empty where it may not be read, which is reported.
  std::filesystem::path find(std::string_view path, Span place);
  /// Reads what `find` gave; null where that fails, which is reported.
  Unit* read(const std::filesystem::path& canonical, Span place);

  double parse_seconds() const { return parse_seconds_; }
  std::uint64_t bytes() const { return bytes_; }

private:
  std::string display_name(const std::filesystem::path& canonical) const;
  bool is_allowed(const std::filesystem::path& canonical) const;
  /// The name of the file beside it that was likely meant, where it does not exist and `place` names it; or empty.
  std::string like_named(const std::filesystem::path& canonical, Span place) const;

  Program& program_;
  Report& report_;
  std::filesystem::path folder_; // canonical
  std::vector<std::filesystem::path> roots_;
  double parse_seconds_ = 0;
  std::uint64_t bytes_ = 0;
};

/// The whole file. Throws std::system_error with the path in its message.
std::string read_file(const std::filesystem::path& path);

} // namespace rt::lang
