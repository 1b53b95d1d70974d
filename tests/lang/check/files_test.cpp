#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <system_error>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

namespace fs = std::filesystem;
using Codes = std::vector<std::string>;

namespace {

/// A scene's folder in memory.
class Folder {
public:
  /// Adds a file; its path.
  std::string write(const std::string& name, const std::string& text) {
    files_.write("/scene/" + name, text);
    return "/scene/" + name;
  }
  Loaded load(const std::string& path) const {
    LoadOptions options;
    options.files = &files_;
    return load_file(path, options);
  }
  Loaded load_main(const std::string& text) { return load(write("main.rtl", text)); }
  const FileSystem& files() const { return files_; }

private:
  MemoryFiles files_;
};

/// A folder on the disk, gone at the end: for links and pipes.
class DiskFolder {
public:
  DiskFolder() : path_(fs::temp_directory_path() / ("rtlang-files-test-" + std::to_string(::getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~DiskFolder() { fs::remove_all(path_); }
  std::string write(const std::string& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }
  const fs::path& path() const { return path_; }

private:
  fs::path path_;
};

std::size_t objects(const Loaded& loaded) {
  INFO(report(loaded));
  REQUIRE(loaded.scene);
  return loaded.scene->objects.size();
}

} // namespace

TEST_CASE("files: include splices, with its own lines and names") {
  Folder folder;
  folder.write("parts/walls.rtl",
               "brick = material { color: firebrick }\n\nbox { material: brick }\nbackground: navy\n");
  const std::string main = folder.write("main.rtl", "include \"parts/walls.rtl\"\nsphere { material: brick }\n");
  const Loaded loaded = folder.load(main);
  CHECK(objects(loaded) == 2);
  const scene::Origin origin = loaded.scene->objects[0].origin;
  CHECK(loaded.scene->files[origin.file] == "parts/walls.rtl");
  CHECK(origin.line == 3);
  CHECK(loaded.scene->background.b > 0.2);
}

TEST_CASE("files: an included file may include its neighbours, and functions may come after their use") {
  Folder folder;
  folder.write("lib/a.rtl", "include \"b.rtl\"\nsphere { radius: size() }\n");
  folder.write("lib/b.rtl", "fn size() = twice(2)\n");
  const Loaded loaded = folder.load_main("include \"lib/a.rtl\"\nfn twice(x) = 2 * x\n");
  CHECK(objects(loaded) == 1);
  CHECK(loaded.scene->shapes.all<scene::Sphere>()[0].radius == 4);
}

TEST_CASE("files: use gives names and places nothing") {
  Folder folder;
  folder.write("lib.rtl", "background: red\nheight = 3\nfn double(x) = 2 * x\ndef post(h = height) { box { size: [1, "
                          "h, 1] } }\nsphere {}\n");
  const Loaded loaded = folder.load_main("use \"lib.rtl\" as lib\nuse \"lib.rtl\" as again\nlib.post {}\nlib.post { h: "
                                         "lib.double(lib.height) }\nagain.post {}\n");
  CHECK(objects(loaded) == 3);
  CHECK(loaded.scene->background == black);
  CHECK(loaded.scene->shapes.all<scene::Box>().size() == 2); // the same module: the first post and the third are one
  CHECK(errors(folder.load(
            folder.write("wrong.rtl", "use \"lib.rtl\" as lib\nsphere { radius: height }\nlib.pole {}\n"))) ==
        Codes{"E0201", "E0212"});
}

TEST_CASE("files: modules use modules") {
  Folder folder;
  folder.write("inner.rtl", "r = 4\n");
  folder.write("outer.rtl", "use \"inner.rtl\" as inner\nball = sphere { radius: inner.r }\n");
  const Loaded loaded = folder.load_main("use \"outer.rtl\" as o\no.ball\nsphere { radius: o.inner.r }\n");
  CHECK(objects(loaded) == 2);
  CHECK(loaded.scene->shapes.all<scene::Sphere>()[1].radius == 4);
}

TEST_CASE("files: cycles are reported") {
  Folder folder;
  folder.write("a.rtl", "include \"b.rtl\"\n");
  folder.write("b.rtl", "use \"a.rtl\" as a\n");
  CHECK(errors(folder.load("/scene/a.rtl")) == Codes{"E0602"});
  CHECK(errors(folder.load(folder.write("self.rtl", "include \"self.rtl\"\n"))) == Codes{"E0602"});
  folder.write("u.rtl", "use \"v.rtl\" as v\n");
  folder.write("v.rtl", "use \"u.rtl\" as u\n");
  CHECK(errors(folder.load_main("use \"u.rtl\" as u\nsphere {}\n")) == Codes{"E0602"});
}

TEST_CASE("files: an included pipe is refused, not waited for") {
  const DiskFolder folder;
  REQUIRE(::mkfifo((folder.path() / "pipe").c_str(), 0600) == 0);
  CHECK(errors(load_file(folder.write("main.rtl", "include \"pipe\"\n"), {})) == Codes{"E0601"});
}

TEST_CASE("files: nothing outside of the scene's folder is read, not even through a link") {
  const DiskFolder folder;
  folder.write("secret.rtl", "sphere {}\n");
  folder.write("scene/inside.rtl", "sphere {}\n");
  fs::create_symlink(folder.path() / "secret.rtl", folder.path() / "scene/link.rtl");
  fs::create_directory_symlink(folder.path(), folder.path() / "scene/up");
  const auto codes = [&](const std::string& path, const LoadOptions& options = {}) {
    return errors(load_file(folder.write("scene/main.rtl", "include \"" + path + "\"\n"), options));
  };
  CHECK(codes("inside.rtl").empty());
  CHECK(codes("../scene/inside.rtl").empty());
  CHECK(codes("../secret.rtl") == Codes{"E0603"});
  CHECK(codes("link.rtl") == Codes{"E0603"});
  CHECK(codes("up/secret.rtl") == Codes{"E0603"});
  CHECK(codes((folder.path() / "secret.rtl").string()) == Codes{"E0603"});
  CHECK(codes("../no_such_file.rtl") == Codes{"E0603"}); // nor is it told what is there
  LoadOptions options;
  options.include_roots = {folder.path().string()};
  CHECK(codes("../secret.rtl", options).empty());
  CHECK(codes("secret.rtl", options).empty()); // looked for in the added folders, too
}

TEST_CASE(
    "files: where a file is missing, one of a like name is reported, but not from outside of the scene's folder") {
  const DiskFolder folder;
  folder.write("secret.rtl", "");
  folder.write("scene/walls.rtl", "");
  folder.write("scene/a.rtl", "");
  folder.write("scene/lib/roofs.rtl", "include \"rofs.rtl\"\n");
  fs::create_directories(folder.path() / "scene/tiles.rtl");
  fs::create_symlink(folder.path() / "secret.rtl", folder.path() / "scene/secrets.rtl");
  const auto label = [&](const std::string& line) {
    const Loaded loaded = load_file(folder.write("scene/main.rtl", line + "\n"), {});
    REQUIRE(find(loaded, "E0601"));
    return find(loaded, "E0601")->label;
  };
  const auto none = [](const std::string& name) { return name + ": No such file or directory"; };
  const auto meant = [&](const std::string& name, const std::string& guess) {
    return none(name) + "; did you mean `" + guess + "`?";
  };
  CHECK(label("include \"wals.rtl\"") == meant("wals.rtl", "walls.rtl"));
  CHECK(label("use \"Walls.rtl\" as w") == meant("Walls.rtl", "walls.rtl"));
  CHECK(label("include \"walls\"") == meant("walls", "walls.rtl"));
  CHECK(label("include \"lib/rools.rtl\"") == meant("lib/rools.rtl", "roofs.rtl"));
  CHECK(label("include \"b.rtl\"") == none("b.rtl"));       // one letter out of one
  CHECK(label("include \"tile.rtl\"") == none("tile.rtl")); // a folder
  CHECK(label("include \"man.rtl\"") == none("man.rtl"));   // would include itself
  CHECK(label("include \"lib/roofs.rtl\"") == none("lib/rofs.rtl"));
  CHECK(label("include \"secret_.rtl\"") == none("secret_.rtl")); // a link that leads out
  CHECK(label("include \"no/walls.rtl\"") == none("no/walls.rtl"));
}

TEST_CASE("files: a folder is no file, and a missing scene is an exception") {
  const DiskFolder folder;
  folder.write("sub/x.rtl", "");
  CHECK(errors(load_file(folder.write("main.rtl", "include \"sub\"\n"), {})) == Codes{"E0601"});
  CHECK_THROWS_AS(load_file((folder.path() / "missing.rtl").string(), {}), std::system_error);
  CHECK_THROWS_AS(load_file(folder.path().string(), {}), std::system_error);
}

TEST_CASE("files: a text that is no file includes from the folder it is given") {
  Folder folder;
  folder.write("part.rtl", "sphere {}\n");
  LoadOptions options;
  options.files = &folder.files();
  CHECK(load_text("include \"part.rtl\"", "-", "/scene", options).scene->objects.size() == 1);
}

TEST_CASE("params: the command line sets them") {
  const auto with = [](std::vector<std::pair<std::string, std::string>> defines) {
    LoadOptions options;
    options.defines = std::move(defines);
    Loaded loaded = load("param n = 3 in 1..6\nparam shade = red\nparam label = \"a\"\nparam at = [0, 0, 0]\nfor i in "
                         "0..<n { sphere { material: shade, name: label, at: at } }",
                         options);
    return loaded;
  };
  const auto scene_with = [&](std::vector<std::pair<std::string, std::string>> defines) {
    Loaded loaded = with(std::move(defines));
    INFO(report(loaded));
    REQUIRE(loaded.scene);
    return *std::move(loaded.scene);
  };
  CHECK(scene_with({}).objects.size() == 3);
  CHECK(scene_with({{"n", "2 * 3"}}).objects.size() == 6);
  CHECK(scene_with({{"n", "floor(sqrt(4.5))"}}).objects.size() == 2);
  CHECK(std::get<Color>(scene_with({{"shade", "#0000ff"}}).materials[0].color) == Color{0, 0, 1});
  CHECK(scene_with({{"shade", "0.5"}}).materials[0].color == scene::Paint(grey(0.5)));
  CHECK(scene_with({{"label", "\"b\""}}).names[0] == "b");
  CHECK(scene_with({{"at", "[1, 2, 3]"}}).objects[0].at == Vec3{1, 2, 3});
  CHECK(scene_with({{"n", "1"}, {"n", "2"}}).objects.size() == 2); // the last one counts
  CHECK(errors(with({{"n", "7"}})) == Codes{"E0606"});
  CHECK(errors(with({{"n", "red"}})) == Codes{"E0605"});
  CHECK(errors(with({{"m", "7"}})) == Codes{"E0604"});
  CHECK(errors(with({{"n", "n"}})) == Codes{"E0201"});
  CHECK(errors(with({{"n", "1 +"}})) == Codes{"E0101"});
  CHECK(errors(with({{"label", "b"}})) == Codes{"E0201"});
}
