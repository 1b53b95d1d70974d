#include "tests/oracle/live.hpp"
#include "tests/paths.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace rt;
using namespace rt::tests;
namespace povray = rt::tools::povray;
using Catch::Contains;

namespace {

// A folder of our own for temporary files, so that tests that run at the same time do not disturb the count.
class OwnTemporaryFolder {
public:
  OwnTemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "oracle-test-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()));
    path_ = name;
    setenv("TMPDIR", name.c_str(), 1);
  }
  ~OwnTemporaryFolder() {
    unsetenv("TMPDIR");
    std::filesystem::remove_all(path_);
  }
  bool is_empty() const { return std::filesystem::is_empty(path_); }
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

struct Ran {
  int exit_code;
  std::string output;
};

Ran run(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string output;
  for (int c = fgetc(pipe); c != EOF; c = fgetc(pipe)) output += static_cast<char>(c);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

const std::string good =
    "#version 3.7; global_settings { assumed_gamma 1.0 } camera { location -z*3 direction z right x up y }\n"
    "sphere { 0, 1 pigment { rgb <3, -0.5, 0.25> } finish { ambient 0 diffuse 0 emission 1 } }";

} // namespace

TEST_CASE("POV-Ray: pictures are floats, neither clamped nor rounded, and nothing is left behind") {
  const OwnTemporaryFolder folder;
  const povray::Picture picture = povray::render(good, 8, 8, {});
  REQUIRE(picture.is_float);
  CHECK(picture.color[3 * 8 + 3].r == 3);
  CHECK(picture.color[3 * 8 + 3].g == -0.5f);
  CHECK(picture.packed[3 * 8 + 3].r == 65535);
  CHECK(picture.packed[3 * 8 + 3].b == 16384);
  CHECK(folder.is_empty());
}

TEST_CASE("POV-Ray: what it refuses is told in its own words, and nothing is left behind") {
  const OwnTemporaryFolder folder;
  CHECK_THROWS_WITH(povray::render("#version 3.7; spere { 0, 1 }", 8, 8, {}),
                    Contains("Parse Error") && Contains("spere"));
  CHECK(folder.is_empty());
}

TEST_CASE("POV-Ray: a scene that takes too long is ended, and nothing is left behind") {
  const OwnTemporaryFolder folder;
  povray::RunOptions options;
  options.time_limit = std::chrono::milliseconds(300);
  CHECK_THROWS_WITH(povray::render("#version 3.7; #while (1) #end", 8, 8, options),
                    Contains("did not finish within 0.3 s"));
  CHECK(folder.is_empty());
}

TEST_CASE("POV-Ray: a stop from outside ends it") {
  const std::atomic<bool> stop = true;
  povray::RunOptions options;
  options.stop = &stop;
  CHECK_THROWS_WITH(povray::render("#version 3.7; #while (1) #end", 8, 8, options), Contains("stopped"));
}

TEST_CASE("POV-Ray: a name in a scene reaches neither a shell nor the text around its comment") {
  const OwnTemporaryFolder folder;
  const scene::Scene scene = scene_of("sphere { name: \"$(touch oops) `touch oops`; \\n #error */ x\" }");
  CHECK_NOTHROW(povray::render(povray::export_povray(scene).text, 8, 8, {}));
  CHECK(folder.is_empty());
}

TEST_CASE("check: without POV-Ray it names the package and exits with 3") {
  const Ran ran =
      run(std::string("PATH=/nonexistent ") + RTLANG_BINARY + " check " + RTLANG_SOURCE_DIR + "/examples/hello.rtl");
  CHECK(ran.exit_code == 3);
  CHECK_THAT(ran.output, Contains("POV-Ray is not installed") && Contains("package `povray`"));
}

TEST_CASE("check: 0 when every gate holds, 1 when one does not, a page and JSON on demand") {
  const OwnTemporaryFolder folder;
  const std::string scene = std::string(RTLANG_SOURCE_DIR) + "/examples/hello.rtl";
  const std::string command = std::string(RTLANG_BINARY) + " check " + scene + " --size 40x30 ";
  const std::string page = (folder.path() / "page.html").string();
  const Ran fine = run(command + "--quiet --json --report " + page);
  CHECK(fine.exit_code == 0);
  CHECK_THAT(fine.output, Contains("\"holds\": true"));
  std::ifstream in(page);
  const std::string html{std::istreambuf_iterator<char>(in), {}};
  CHECK_THAT(html,
             Contains("data:image/png;base64,") && Contains("hello.rtl") && !Contains("%TITLE%") && !Contains("http"));
  CHECK(run(command + "--gate depth=1e-20").exit_code == 1);
  CHECK(run(command + "--gate nothing=1").exit_code == 2);
}

TEST_CASE("check: an explained pixel is named with its object, line and cause") {
  const Checked c =
      check_scene(scene_of("size: [60, 45]\ncamera { at: [0, 1, 4] }\nlight { at: [2, 4, 3] }\n"
                           "sphere { radius: 0.00002, at: [0, 1, 3.99995] }\nsphere { name: \"ball\" }\n"));
  // The tiny sphere is nearer to the eye than 1e-4: POV-Ray looks through it.
  REQUIRE_FALSE(c.comparison.outliers.empty());
  CHECK(c.comparison.ids_unexplained == 0);
  CHECK(c.comparison.color_unexplained == 0);
  povray::Report report;
  report.scene = "test.rtl";
  report.description = &c.scene;
  report.film = &c.film;
  report.shots = &c.shots;
  report.comparison = c.comparison;
  CHECK_THAT(report_text(report), Contains("POV-Ray's tolerance: sphere, test.rtl:4"));
}

// Found by the long run: a horizon is farther away than POV-Ray sees, straight, in a mirror and through glass.
TEST_CASE("check: what is farther away than POV-Ray sees is explained by that") {
  const std::string view = "size: [16, 12]\nbackground: #336699\ncamera { at: [0, 1, 0], look_at: [1, 1.00000003, 0], "
                           "fov: 0.00001 }\nsun {}\n";
  for (const char* things : {"plane {}",
                             "plane {}\nquad { corner: [2, 0, -1], edge_u: [0, 3, 0], edge_v: [0, 0, 2], material: "
                             "material { refract: 0.8, reflect: 0.2, diffuse: 0 } }",
                             "plane { material: material { color: peru, reflect: 0.3 } }"}) {
    const Checked c = check_scene(scene_of(view + things));
    INFO(things);
    CHECK_FALSE(c.comparison.outliers.empty());
    CHECK(c.comparison.ids_unexplained == 0);
    CHECK(c.comparison.color_unexplained == 0);
    for (const povray::Outlier& o : c.comparison.outliers) CHECK(o.cause == povray::Cause::tolerance);
  }
}

TEST_CASE("export: POV-Ray keeps every bit of the numbers that are written") {
  const double values[] = {0.1, 1.0 / 3, 123456.789012345678, 5e-5, 1 + 1e-15};
  std::string script = "#version 3.7; global_settings { assumed_gamma 1.0 } camera { location 0 direction z }\n#fopen "
                       "OUT \"out\" write\n";
  for (const double v : values) script += fmt::format("#write (OUT, str({} * 1e10, 0, 17), \"\\n\")\n", v);
  const std::string out = povray::run_script(script + "#fclose OUT\n", {}, "out");
  const char* at = out.c_str();
  for (const double v : values) {
    char* end = nullptr;
    CHECK(std::strtod(at, &end) == v * 1e10);
    at = end;
  }
}
