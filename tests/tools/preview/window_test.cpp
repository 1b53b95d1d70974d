// A real window on a real screen that nobody looks at, with keys and clicks from outside.

#include "tests/paths.hpp"
#include "tests/support/program.hpp"

#include <catch2/catch.hpp>
#include <unistd.h>

using namespace rt::tests;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// Runs a script on a screen of its own. In it `view` opens the scene's window in the background and waits for it,
/// `press KEYS…` and `click X Y` are sent to that, and `until_holds FILE TEXT` waits for a file to hold a text.
Outcome on_screen(const TestFolder& folder, const std::string& script) {
  folder.write("session.sh", R"(set -e
view() {
  )" RTLANG_BINARY R"( view scene.rtl > out.txt 2> err.txt &
  program=$!
  window=$(timeout 20 xdotool search --sync --onlyvisible --name '^scene.rtl')
  xdotool windowfocus --sync $window
}
press() { xdotool key --delay 50 "$@"; }
click() { xdotool mousemove --window $window $1 $2 click 1; }
until_holds() { for i in $(seq 200); do grep -qs -- "$2" $1 && return; sleep 0.1; done; echo "no $2 in $1" >&2; false; }
)" + script);
  RunOptions options;
  options.folder = folder.path();
  options.environment = {"SDL_VIDEODRIVER=x11", "PATH=/usr/bin:/bin"};
  options.time_limit = std::chrono::seconds(90);
  // Tests that run at once look for a free screen each from a place of its own.
  const std::string first = std::to_string(100 + ::getpid() % 5000);
  return run_program("/bin/sh",
                     {"/usr/bin/xvfb-run", "-a", "-n", first, "-s", "-screen 0 800x600x24", "/bin/bash", "session.sh"},
                     options);
}

constexpr const char* scene = "size: [200, 150]\nball = sphere { material: red }\nball\n";

} // namespace

TEST_CASE("window: keys and clicks ask, move and save, and Escape closes it") {
  const TestFolder folder;
  folder.write("scene.rtl", scene);
  const Outcome outcome = on_screen(folder, R"(view
click 100 75; until_holds out.txt '`ball`'
press Right c; until_holds out.txt 'camera { at:'
press p w; until_holds out.txt linear
press r s; sleep 1; press s; until_holds out.txt 'saved scene.png'
press Escape; wait $program; echo "exit $?")");
  INFO(outcome.errors);
  CHECK(outcome.output == "exit 0\n");
  CHECK_THAT(folder.read("out.txt"), Contains("pixel (100, 75)"));
  CHECK_THAT(folder.read("scene.png"), StartsWith("\x89PNG"));
}

TEST_CASE("window: it follows the file, and keeps the last good picture while the text is wrong") {
  const TestFolder folder;
  folder.write("scene.rtl", scene);
  const Outcome outcome = on_screen(folder, R"(view
echo 'sphere { radius: }' > scene.rtl; until_holds err.txt 'error'
click 100 75; until_holds out.txt '`ball`'
printf 'size: [200, 150]\ncube = box { size: 2 }\ncube\n' > new.rtl; mv new.rtl scene.rtl
for i in $(seq 100); do click 100 75; grep -q '`cube`' out.txt && break; sleep 0.1; done
press q; wait $program; echo "exit $?")");
  INFO(outcome.errors);
  CHECK(outcome.output == "exit 0\n");
  CHECK_THAT(folder.read("out.txt"), Contains("`cube`"));
}

TEST_CASE("window: a signal closes it, and without a screen it says what to do instead") {
  const TestFolder folder;
  folder.write("scene.rtl", scene);
  const Outcome stopped = on_screen(folder, "view; kill -TERM $program; wait $program || echo \"exit $?\"");
  CHECK(stopped.output == "exit 143\n");
  RunOptions options;
  options.folder = folder.path();
  const Outcome blind = rtlang({"view", "scene.rtl"}, options);
  CHECK(blind.exit_code == 3);
  CHECK_THAT(blind.errors, Contains("no display is available") && Contains("rtlang SCENE -o picture.png"));
}
