#include "tests/support/program.hpp"
#include "tools/preview/file_watch.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace rt::tests;
using rt::tools::preview::FileWatch;
using namespace std::chrono_literals;

namespace {

struct Watched {
  TestFolder folder;
  FileWatch watch;
  FileWatch::Clock::time_point now{};
  Watched() {
    folder.write("a.rtl", "sphere {}\n");
    folder.write("b.rtl", "box {}\n");
    watch.follow({folder / "a.rtl", folder / "b.rtl"});
  }
  bool has_changed_after(std::chrono::milliseconds time) { return watch.has_changed(now += time); }
};

} // namespace

TEST_CASE("file watch: what is saved in place, and what takes the old one's name, is noticed once") {
  Watched w;
  CHECK_FALSE(w.has_changed_after(50ms));
  w.folder.write("a.rtl", "sphere { radius: 2 }\n");
  CHECK(w.has_changed_after(50ms));
  CHECK_FALSE(w.has_changed_after(50ms));
  w.folder.write("b.rtl~", "box { size: 2 }\n");
  std::filesystem::rename(w.folder / "b.rtl~", w.folder / "b.rtl");
  CHECK(w.has_changed_after(50ms));
  CHECK_FALSE(w.has_changed_after(50ms));
}

TEST_CASE("file watch: a file that is missing or empty for a moment is being written") {
  Watched w;
  w.folder.write("a.rtl", "");
  CHECK_FALSE(w.has_changed_after(50ms));
  CHECK_FALSE(w.has_changed_after(299ms));
  w.folder.write("a.rtl", "sphere { radius: 3 }\n");
  CHECK(w.has_changed_after(50ms));
  std::filesystem::remove(w.folder / "a.rtl");
  CHECK_FALSE(w.has_changed_after(50ms));
  CHECK(w.has_changed_after(300ms)); // it stays away
  CHECK_FALSE(w.has_changed_after(300ms));
  w.folder.write("a.rtl", "sphere {}\n");
  CHECK(w.has_changed_after(50ms));
}
