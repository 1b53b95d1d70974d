#include "lang/text/file_system.hpp"

#include <catch2/catch.hpp>

#include <system_error>

using namespace rt::lang;
using Names = std::vector<std::string>;

TEST_CASE("files in memory: paths lead to a file in any spelling") {
  MemoryFiles files;
  files.write("/scene/main.rtl", "sphere {}");
  CHECK(files.read("/scene/main.rtl") == "sphere {}");
  CHECK(files.read("/scene/parts/../main.rtl") == "sphere {}");
  CHECK(files.exists("scene/./main.rtl"));
  CHECK_FALSE(files.exists("/main.rtl"));
  CHECK(files.canonical("/scene/../../x") == "/x");
  CHECK_THROWS_AS(files.read("/scene/other.rtl"), std::system_error);
  CHECK_THROWS_AS(files.read("/scene"), std::system_error);
}

TEST_CASE("files in memory: a folder lists its own files only") {
  MemoryFiles files;
  files.write("/scene/b.rtl", "");
  files.write("/scene/a.rtl", "");
  files.write("/scene/parts/c.rtl", "");
  CHECK(files.files_in("/scene") == Names{"a.rtl", "b.rtl"});
  CHECK(files.files_in("/nowhere").empty());
}

TEST_CASE("open buffers: what is open stands before what is saved") {
  MemoryFiles saved;
  saved.write("/scene/main.rtl", "saved");
  OpenBuffers buffers(saved);
  CHECK(buffers.read("/scene/main.rtl") == "saved");
  buffers.open("/scene/../scene/main.rtl", "typed");
  CHECK(buffers.read("/scene/main.rtl") == "typed");
  buffers.open("/scene/new.rtl", "never saved");
  CHECK(buffers.exists("/scene/new.rtl"));
  CHECK(buffers.files_in("/scene") == Names{"main.rtl", "new.rtl"});
  buffers.close("/scene/main.rtl");
  CHECK(buffers.read("/scene/main.rtl") == "saved");
  CHECK(saved.files_in("/scene") == Names{"main.rtl"});
}

TEST_CASE("disk: a missing file and a folder are exceptions that name the path") {
  CHECK_THROWS_WITH(disk().read("/no/such/file"), Catch::Contains("/no/such/file"));
  CHECK_THROWS_WITH(disk().read("/"), Catch::Contains("/: Is a directory"));
  CHECK_FALSE(disk().exists("/no/such/file"));
  CHECK(disk().files_in("/no/such/folder").empty());
}
