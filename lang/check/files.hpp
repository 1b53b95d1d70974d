#pragma once

#include "lang/check/program.hpp"
#include "lang/diagnostics/report.hpp"
#include "lang/text/file_system.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt::lang {

/// Reads and parses the files named by `include` and `use`. They must be in the folder of the scene or below it, or in
/// folders added on the command line, after symbolic links are resolved.
class Files {
public:
  /// `folder` is the scene's; it need not exist if nothing is read from it.
  Files(Program& program, Report& report, const FileSystem& file_system, const std::filesystem::path& folder,
        const std::vector<std::string>& roots);

  std::string folder() const { return folder_.string(); }
  /// Sets the scene's folder.
  void set_folder(const std::filesystem::path& folder);

  /// Adds a text to the program and parses it.
  Unit& parse_text(std::string name, std::string path, std::string text, Span included_from = {});
  /// The library, and the values from the command line by the names of their params.
  void parse_library_and_defines(const std::vector<std::pair<std::string, std::string>>& defines);
  /// From now on every item gets its own nodes, even repeated ones.
  void unfold_repeats() { folds_repeats_ = false; }

  /// The path of the file that the text at `place` names; empty if it may not be read, which is reported.
  std::filesystem::path find(std::string_view path, Span place);
  /// Reads what `find` returned; null if that fails, which is reported.
  Unit* read(const std::filesystem::path& canonical, Span place);

  double parse_seconds() const { return parse_seconds_; }
  std::uint64_t bytes() const { return bytes_; }

private:
  Unit& parse_expression_text(std::string name, std::string text);
  std::string display_name(const std::filesystem::path& canonical) const;
  void note_division_comments(FileId file);
  bool is_allowed(const std::filesystem::path& canonical) const;
  /// If the file that `place` names does not exist: the similar name of a file beside it that was probably intended.
  std::string like_named(const std::filesystem::path& canonical, Span place) const;

  Program& program_;
  Report& report_;
  const FileSystem& file_system_;
  std::filesystem::path folder_; // canonical
  std::vector<std::filesystem::path> roots_;
  bool folds_repeats_ = true;
  double parse_seconds_ = 0;
  std::uint64_t bytes_ = 0;
};

} // namespace rt::lang
