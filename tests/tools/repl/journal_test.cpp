#include "tools/repl/journal.hpp"

#include <catch2/catch.hpp>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using rt::tools::find_abandoned_sessions;
using rt::tools::Journal;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("rtlang_journal_test_" + std::to_string(getpid()));
  Folder() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  std::string name() const { return path.string(); }
  std::string only_file() const { return fs::directory_iterator(path)->path().string(); }
};

TEST_CASE("journal: entries of a session that left them are found, newlines and all") {
  const Folder folder;
  {
    Journal journal(folder.name());
    journal.add("sphere {}");
    journal.add("box {\n  size: 2\n}");
  }
  const auto found = find_abandoned_sessions(folder.name());
  REQUIRE(found.size() == 1);
  CHECK(found[0].entries == std::vector<std::string>{"sphere {}", "box {\n  size: 2\n}"});
  CHECK(found[0].working_folder == fs::current_path().string());
}

TEST_CASE("journal: a session that still runs is nobody else's") {
  const Folder folder;
  Journal journal(folder.name());
  journal.add("sphere {}");
  CHECK(find_abandoned_sessions(folder.name()).empty());
}

TEST_CASE("journal: what is cleared leaves nothing behind") {
  const Folder folder;
  Journal journal(folder.name());
  CHECK(fs::is_empty(folder.path));
  journal.add("sphere {}");
  journal.clear();
  CHECK(fs::is_empty(folder.path));
}

TEST_CASE("journal: the base is written with the first entry after it") {
  const Folder folder;
  {
    Journal journal(folder.name());
    journal.clear(":load \"a.rtl\"");
    CHECK(fs::is_empty(folder.path));
    journal.add("sphere {}");
  }
  CHECK(find_abandoned_sessions(folder.name()).at(0).entries ==
        std::vector<std::string>{":load \"a.rtl\"", "sphere {}"});
}

TEST_CASE("journal: all that were left are found, the latest first, and the oldest of very many go") {
  const Folder folder;
  for (int i = 1; i <= 11; ++i) {
    const std::string path = folder.path / ("session-" + std::to_string(i) + "-1.journal");
    std::ofstream(path) << "rtlang journal 1\n/\n1\n" << i % 10 << "\n";
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(20 - i));
  }
  const auto found = find_abandoned_sessions(folder.name());
  std::string entries;
  for (const auto& session : found) entries += session.entries.at(0);
  CHECK(entries == "109876543"); // of 11, 10, 9 …, the last digit
  CHECK_FALSE(fs::exists(folder.path / "session-2-1.journal"));
}

TEST_CASE("journal: an entry that was cut off by the end of the program does not count") {
  const Folder folder;
  {
    Journal journal(folder.name());
    journal.add("sphere {}");
    journal.add("box { size: [1, 2, 3] }");
  }
  fs::resize_file(folder.only_file(), fs::file_size(folder.only_file()) - 5);
  CHECK(find_abandoned_sessions(folder.name()).at(0).entries == std::vector<std::string>{"sphere {}"});
}

TEST_CASE("journal: a file that is none is removed, and other files are left alone") {
  const Folder folder;
  std::ofstream(folder.path / "session-1-1.journal") << "something else\n";
  std::ofstream(folder.path / "history") << "sphere {}\n";
  CHECK(find_abandoned_sessions(folder.name()).empty());
  CHECK(fs::exists(folder.path / "history"));
  CHECK_FALSE(fs::exists(folder.path / "session-1-1.journal"));
}

} // namespace
