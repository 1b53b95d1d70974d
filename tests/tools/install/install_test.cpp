// What a user gets: the installed files, and a README that tells the truth.

#include "tests/paths.hpp"
#include "tests/support/program.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

using namespace rt::tests;
namespace fs = std::filesystem;

namespace {

std::string readme() {
  std::ostringstream text;
  text << std::ifstream(fs::path(RTLANG_SOURCE_DIR) / "README.md").rdbuf();
  return text.str();
}

/// The blocks of a Markdown text that are marked as `language`.
std::vector<std::string> blocks(const std::string& text, const std::string& language) {
  const std::string begin = "\n```" + language + "\n";
  std::vector<std::string> list;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const std::size_t first = at + begin.size();
    list.push_back(text.substr(first, text.find("\n```", first) + 1 - first));
  }
  return list;
}

} // namespace

TEST_CASE("install: program, library, examples, manual page and completion are where they belong, and it runs") {
  const TestFolder folder;
  const fs::path build = fs::path(RTLANG_BINARY).parent_path();
  const Outcome install =
      run_program("/usr/bin/cmake", {"--install", build.string(), "--prefix", folder.path().string()});
  REQUIRE(install.exit_code == 0);
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder.path()).generic_string());
  for (const char* file : {"bin/rtlang", "share/man/man1/rtlang.1", "share/bash-completion/completions/rtlang",
                           "share/zsh/site-functions/_rtlang", "share/rtlang/examples/first.rtl",
                           "share/doc/rtlang/README.md", "share/doc/rtlang/LICENSE"}) {
    INFO(file);
    CHECK(files.contains(file));
  }
  bool has_library = false;
  for (const std::string& file : files)
    has_library |= file.starts_with("share/rtlang/library/") && file.ends_with(".rtl");
  CHECK(has_library);

  // It uses nothing of the place where it was built.
  const Outcome run = run_program(folder / "bin/rtlang", {folder / "share/rtlang/examples/metals.rtl", "--size",
                                                          "16x12", "-q", "-o", folder / "out.png"});
  CHECK(run.exit_code == 0);
  CHECK(run.errors.empty());
  CHECK(folder.read("out.png").size() > 100);
}

TEST_CASE("install: bash without extglob completes commands, files, and the names that `doc` knows") {
  const TestFolder folder;
  folder.write("scene.rtl", "sphere {}\n");
  folder.write("notes.txt", "");
  const auto completions = [&](const std::string& words) {
    const std::string script =
        "shopt -u extglob; source " RTLANG_SOURCE_DIR "/tools/install/rtlang.bash; COMP_WORDS=(" + words +
        "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rtlang; printf '%s\\n' \"${COMPREPLY[@]}\"";
    RunOptions options;
    options.folder = folder.path();
    const Outcome run = run_program("/bin/bash", {"--norc", "-c", script}, options);
    CHECK(run.errors.empty());
    return run.output;
  };
  const std::string program = RTLANG_BINARY;
  CHECK(completions(program + " sce") == "scene\nscene.rtl\n");
  CHECK(completions(program + " lint ''") == "scene.rtl\n");
  CHECK(completions(program + " doc sph") == "sphere\nspherical\n");
  CHECK(completions(program + " doc rad") == "radius\n");
  CHECK(completions(program + " doc mirr") == "mirror\n");
  CHECK(completions(program + " doc expe") == "expect\n");
  CHECK(completions(program + " explain E060").starts_with("E0601\nE0602\n"));
}

TEST_CASE("readme: every scene in it renders") {
  const auto scenes = blocks(readme(), "rtl");
  REQUIRE_FALSE(scenes.empty());
  for (const std::string& scene : scenes) {
    INFO(scene);
    RunOptions options;
    options.input = scene;
    CHECK(rtlang({"-", "-o", "-", "--size", "16x12", "-q"}, options).exit_code == 0);
  }
}

TEST_CASE("readme: the scene it begins with is the one that setup renders") {
  std::ostringstream first;
  first << std::ifstream(fs::path(RTLANG_SOURCE_DIR) / "examples/first.rtl").rdbuf();
  const std::string comment = first.str().substr(0, first.str().find('\n') + 1);
  CHECK(comment.starts_with("//"));
  CHECK(first.str() == comment + blocks(readme(), "rtl").at(0));
}

TEST_CASE("readme: what it shows is there") {
  const std::string text = readme();
  const fs::path root = RTLANG_SOURCE_DIR;
  int count = 0;
  for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1), ++count) {
    const std::string target = text.substr(at + 2, text.find(')', at) - at - 2);
    INFO(target);
    if (!target.starts_with("http")) CHECK(fs::exists(root / target.substr(0, target.find('#'))));
  }
  CHECK(count > 3);
  CHECK(fs::exists(root / "tools/setup"));
  CHECK(fs::exists(root / "tools/test"));
}
