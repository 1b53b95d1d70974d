#include "renderer/image/file.hpp"

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

using namespace rt;
namespace fs = std::filesystem;

namespace {

/// A new folder, removed with all that is in it.
struct Folder {
  fs::path path;
  Folder() {
    std::string name = (fs::temp_directory_path() / "rtlang-test-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
  }
  ~Folder() { fs::remove_all(path); }
  std::string operator/(const char* name) const { return (path / name).string(); }
  std::vector<std::string> names() const {
    std::vector<std::string> list;
    for (const auto& entry : fs::directory_iterator(path)) list.push_back(entry.path().filename().string());
    std::sort(list.begin(), list.end());
    return list;
  }
};

std::error_code error_of(const std::string& path, std::string_view bytes) {
  try {
    replace_file(path, bytes);
  } catch (const std::system_error& error) {
    CHECK(std::string(error.what()).find("`" + path + "`") != std::string::npos);
    return error.code();
  }
  return {};
}

} // namespace

TEST_CASE("file: a new file and a replaced one hold the bytes, and nothing else is left") {
  const Folder folder;
  replace_file(folder / "a", "first");
  CHECK(read_file(folder / "a") == "first");
  ::chmod((folder / "a").c_str(), 0640);
  replace_file(folder / "a", "");
  CHECK(read_file(folder / "a").empty());
  CHECK(folder.names() == std::vector<std::string>{"a"});
  struct stat status {};
  ::stat((folder / "a").c_str(), &status);
  CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("file: a link stays a link and what it names is replaced") {
  const Folder folder;
  replace_file(folder / "a", "first");
  fs::create_symlink("a", folder.path / "link");
  replace_file(folder / "link", "second");
  CHECK(fs::is_symlink(folder.path / "link"));
  CHECK(read_file(folder / "a") == "second");
}

TEST_CASE("file: a missing folder, a folder, a name too long and a full device are errors that name the path") {
  const Folder folder;
  CHECK(error_of(folder / "no/a", "x") == std::errc::no_such_file_or_directory);
  CHECK(error_of(folder.path.string(), "x") == std::errc::is_a_directory);
  CHECK(error_of(folder.path.string() + "/" + std::string(300, 'n'), "x") == std::errc::filename_too_long);
  CHECK(error_of("/dev/full", "x") == std::errc::no_space_on_device);
  CHECK(folder.names().empty());
  CHECK_THROWS_AS(read_file(folder / "no"), std::system_error);
  CHECK_THROWS_AS(read_file(folder.path.string()), std::system_error);
}

TEST_CASE("file: a name of 255 bytes can be written") {
  const Folder folder;
  const std::string name(255, 'n');
  replace_file(folder / name.c_str(), "x");
  CHECK(folder.names() == std::vector<std::string>{name});
}

TEST_CASE("file: a disk that fills up midway leaves the old file and no other") {
  const Folder folder;
  replace_file(folder / "a", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    // Stands for the full disk: no file may grow beyond 1000 bytes.
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      replace_file(folder / "a", std::string(100'000, 'x'));
    } catch (const std::system_error& error) {
      ::_exit(error.code() == std::errc::file_too_large ? 7 : 8);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 7);
  CHECK(read_file(folder / "a") == "old");
  CHECK(folder.names() == std::vector<std::string>{"a"});
}
