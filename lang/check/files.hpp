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

/// Reads and parses the files that `include` and `use` name. They are confined to the folder of the scene and what is
/// below it, and to the folders that the command line added; a symbolic link does not lead out.
class Files {
public:
  /// `folder` is where the scene stands; it need not exist when nothing is read from it.
  Files(Program& program, Report& report, const FileSystem& file_system, const std::filesystem::path& folder,
        const std::vector<std::string>& roots);

  std::string folder() const { return folder_.string(); }
  /// From now on the scene stands there.
  void set_folder(const std::filesystem::path& folder);

  /// Adds a text to the program and parses it.
  Unit& parse_text(std::string name, std::string path, std::string text, Span included_from = {});
  /// The library, and the values of the command line by the names of their params.
  void parse_library_and_defines(const std::vector<std::pair<std::string, std::string>>& defines);
  /// From now on each item has a node of its own, however many are alike.
  void unfold_repeats() { folds_repeats_ = false; }

  /// Where the file is that the text at `place` names; empty where it may not be read, which is reported.
  std::filesystem::path find(std::string_view path, Span place);
  /// Reads what `find` gave; null where that fails, which is reported.
  Unit* read(const std::filesystem::path& canonical, Span place);

  double parse_seconds() const { return parse_seconds_; }
  std::uint64_t bytes() const { return bytes_; }

private:
  Unit& parse_expression_text(std::string name, std::string text);
  std::string display_name(const std::filesystem::path& canonical) const;
  void note_division_comments(FileId file);
  bool is_allowed(const std::filesystem::path& canonical) const;
  /// The name of the file beside it that was likely meant, where it does not exist and `place` names it; or empty.
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
