#include "renderer/compile/compiled_scene.hpp"
#include "tests/support/session_driver.hpp"

#include <algorithm>

using rt::lang::Session;
using rt::lang::SessionResult;
using namespace rt::tests;

TEST_CASE("session: a thing on its own line is placed, a bound one is kept for later") {
  SessionDriver talk;
  talk.say("ball = sphere { radius: 2 }");
  CHECK(talk.count() == 0);
  talk.say("ball");
  talk.say("box {}");
  CHECK(talk.count() == 2);
  CHECK(talk.radius(0) == 2);
  CHECK(talk.session.text() == "ball = sphere { radius: 2 }\nball\nbox {}\n");
}

TEST_CASE("session: an expression that is no thing shows its value and does not join the document") {
  SessionDriver talk;
  CHECK(talk.value("1 + 2") == "3");
  CHECK(talk.value("[1, 2, 3] * 2") == "[2, 4, 6]");
  CHECK(talk.value("[i * i for i in 0..3]") == "[0, 1, 4, 9]");
  talk.say("n = 4");
  CHECK(talk.value("n / 8") == "0.5");
  const SessionResult red = talk.say("red");
  REQUIRE(red.values.front().color);
  CHECK(*red.values.front().color == rt::Color{1, 0, 0});
  CHECK(talk.session.text() == "n = 4\n");
  CHECK(talk.session.version() == 1);
}

TEST_CASE("session: a list of things is placed, one by one") {
  SessionDriver talk;
  talk.say("[sphere { at: [i, 0, 0] } for i in 0..<5]");
  CHECK(talk.count() == 5);
  CHECK(talk.at(3) == rt::Vec3{3, 0, 0});
}

TEST_CASE("session: several statements in one input are several lines") {
  SessionDriver talk;
  talk.say("r = 2\nsphere { radius: r }\nr * 3");
  CHECK(talk.session.text() == "r = 2\nsphere { radius: r }\n");
  CHECK(talk.session.version() == 1);
}

TEST_CASE("session: binding a name again replaces its line, and what depends on it is made anew") {
  SessionDriver talk;
  talk.say("r = 1");
  talk.say("d = 2 * r");
  talk.say("sphere { radius: d }");
  talk.say("box {}");
  const auto before = talk.session.counters();
  const SessionResult result = talk.say("r = 5");
  CHECK(talk.session.text() == "r = 5\nd = 2 * r\nsphere { radius: d }\nbox {}\n");
  CHECK(talk.radius(0) == 10);
  // r itself, d and the sphere; not the box.
  CHECK(talk.session.counters().statements_evaluated - before.statements_evaluated == 3);
  CHECK(result.changes ==
        std::vector<std::string>{"r is now 5", "rebuilt: d = 2 * r", "rebuilt: sphere { radius: d }"});
}

TEST_CASE("session: functions and nouns that are redefined change what calls them, also through each other") {
  SessionDriver talk;
  talk.say("fn double(x) = 2 * x");
  talk.say("fn four(x) = double(double(x))");
  talk.say("def lamp(size = 1) { sphere { radius: four(size) } }");
  talk.say("lamp { size: 3 }");
  CHECK(talk.value("four(1)") == "4");
  talk.say("fn double(x) = 3 * x");
  CHECK(talk.value("four(1)") == "9");
  const auto& scene = talk.session.scene();
  const auto& group = scene.shapes.get<rt::scene::Group>(scene.objects.at(0).shape);
  CHECK(scene.shapes.get<rt::scene::Sphere>(group.members.at(0).shape).radius == 27);
  talk.say("def lamp(size = 1) { box { size: size } \n sphere {} }");
  const auto& again = talk.session.scene();
  CHECK(again.shapes.get<rt::scene::Group>(again.objects.at(0).shape).members.size() == 2);
}

TEST_CASE("session: functions may call each other, and one of them may be replaced") {
  SessionDriver talk;
  talk.say("fn even(n) = if n == 0 { true } else { odd(n - 1) }\nfn odd(n) = if n == 0 { false } else { even(n - 1) }");
  CHECK(talk.value("even(10)") == "true");
  talk.say("fn odd(n) = if n == 0 { true } else { even(n - 1) }");
  CHECK(talk.value("even(3)") == "true");
}

TEST_CASE("session: a name that is bound to itself with changes means what it was") {
  SessionDriver talk;
  talk.say("ball = sphere { radius: 2 }");
  talk.say("ball");
  talk.say("ball = ball { at: [1, 0, 0] }");
  CHECK(talk.radius(0) == 2);
  CHECK(talk.at(0) == rt::Vec3{1, 0, 0});
  talk.say("n = 1 + 2");
  talk.say("n = n * 10");
  CHECK(talk.value("n") == "30");
}

TEST_CASE("session: a line that uses later names moves behind them, with what depends on it") {
  SessionDriver talk;
  talk.say("a = 1");
  talk.say("b = a + 1");
  talk.say("c = 10");
  talk.say("a = c + 1");
  CHECK(talk.session.text() == "c = 10\na = c + 1\nb = a + 1\n");
  CHECK(talk.value("b") == "12");
  const SessionResult result = talk.refuse("a = b + 1");
  CHECK(result.diagnostics.front().message == "`a` would depend on itself: `b` uses it");
}

TEST_CASE("session: a line that begins with a dot changes the last thing, placed or bound") {
  SessionDriver talk;
  talk.refuse(".move(x: 2)");
  talk.say("sphere {}");
  talk.say(".move(x: 2)");
  CHECK(talk.count() == 1);
  CHECK(talk.at(0) == rt::Vec3{2, 0, 0});
  talk.say("ball = sphere { radius: 3 }");
  talk.say(".move(y: 1)");
  talk.say("ball");
  CHECK(talk.at(1) == rt::Vec3{0, 1, 0});
  CHECK(talk.session.text() == "sphere {}.move(x: 2)\nball = sphere { radius: 3 }.move(y: 1)\nball\n");
}

TEST_CASE("session: properties of the scene, the camera and the sky are replaced when they are written again") {
  SessionDriver talk;
  talk.say("background: red");
  talk.say("background: blue");
  CHECK(talk.session.scene().background == rt::Color{0, 0, 1});
  talk.say("camera { at: [1, 2, 3] }");
  talk.say("sphere {}");
  talk.say("camera { at: [4, 5, 6] }");
  CHECK(talk.session.scene().camera.at == rt::Vec3{4, 5, 6});
  CHECK(talk.session.text() == "background: blue\nsphere {}\ncamera { at: [4, 5, 6] }\n");
  talk.say("sun {}");
  talk.say("sky { zenith: red }");
  talk.say("sky { zenith: blue }");
  CHECK(talk.session.scene().lights.size() == 2);
  CHECK(talk.session.text() == "background: blue\nsphere {}\ncamera { at: [4, 5, 6] }\nsun {}\n"
                               "sky { zenith: blue }\n");
  talk.say("group { sky {}\n light { at: [0, 3, 0] } }.move(x: 1)");
  talk.refuse("sky { zenith: red }");
}

TEST_CASE("session: errors change nothing, also those in what depends on the input") {
  SessionDriver talk;
  talk.say("r = 1");
  talk.say("sphere { radius: r }");
  const SessionResult dependent = talk.refuse("r = \"wide\"");
  // The place is where the sphere was typed.
  CHECK(rt::lang::render(dependent.diagnostics.front(), talk.session.sources(), false).find("sphere { radius: r }") !=
        std::string::npos);
  talk.refuse("sphere { raduis: 2 }");
  talk.refuse("sphere { radius: -1 }");
  talk.refuse("nonsense");
  talk.refuse("box { size: }");
  talk.refuse("fine = 1\nsphere { radius: nothing }");
  talk.refuse("fn broken(x) = x + unknown");
  talk.refuse("def bad() { sphere { raduis: 1 } }");
  talk.refuse("for i in 0..2 { sphere { radius: i } }");
  CHECK(talk.count() == 1);
  CHECK(talk.radius(0) == 1);
  CHECK(talk.value("r") == "1");
}

TEST_CASE("session: what does not change is neither evaluated nor in another stretch") {
  SessionDriver talk;
  talk.say("for i in 0..<20000 { sphere { at: [i % 100, 0, i / 100], radius: 0.3 } }");
  for (int i = 0; i < 30; ++i) talk.say("box { at: [" + std::to_string(i) + ", 3, 0] }");
  const auto before = talk.session.ranges();
  REQUIRE(before.size() == 1);
  CHECK(before[0].end == 20000);
  const auto objects = talk.session.counters().objects_evaluated;
  talk.say("sphere { at: [0, 9, 0] }");
  CHECK(talk.session.counters().objects_evaluated == objects + 1);
  const auto after = talk.session.ranges();
  REQUIRE(after.size() == 1);
  CHECK(after[0].stamp == before[0].stamp);
  CHECK(talk.count() == 20031);
}

TEST_CASE("session: random inputs leave a document that says the same when it is loaded") {
  // The session after any sequence of inputs is what its text says.
  std::uint64_t state = 12345;
  const auto next = [&state](std::uint64_t n) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (state >> 33) % n;
  };
  const std::vector<std::string> names{"a", "b", "c", "d"};
  for (int round = 0; round < 20; ++round) {
    Session session(".");
    for (int step = 0; step < 25; ++step) {
      const std::string& name = names[next(4)];
      const std::string& other = names[next(4)];
      switch (next(9)) {
      case 0:
        session.submit(name + " = " + std::to_string(next(9) + 1));
        break;
      case 1:
        session.submit(name + " = " + other + " + 1");
        break;
      case 2:
        session.submit("sphere { radius: 0.1 * " + name + ", at: [" + std::to_string(next(5)) + ", 0, 0] }");
        break;
      case 3:
        session.submit("fn f(x) = x + " + std::to_string(next(5)));
        break;
      case 4:
        session.submit(name + " = f(" + other + ")");
        break;
      case 5:
        session.undo();
        break;
      case 6:
        session.submit(".move(y: 0.5)");
        break;
      case 7:
        session.remove(name);
        break;
      case 8:
        session.submit("def thing(n = 1) { box { size: n * " + other + " / 9 } }\nthing { at: [0, 0, -2] }");
        break;
      }
    }
    const std::string text = session.text();
    INFO(text);
    const rt::lang::Loaded loaded = rt::lang::load_text(text, "document", ".", {});
    for (const rt::lang::Diagnostic& d : loaded.diagnostics) UNSCOPED_INFO(rt::lang::render(d, loaded.sources, false));
    REQUIRE(loaded.scene);
    CHECK(loaded.scene->objects.size() == session.scene().objects.size());
    CHECK(are_equal(picture(*loaded.scene), picture(session.scene())));
    const rt::lang::Loaded formatted = rt::lang::load_text(session.formatted(), "formatted", ".", {});
    REQUIRE(formatted.scene);
    CHECK(are_equal(picture(*formatted.scene), picture(session.scene())));
  }
}

TEST_CASE("session: the formatted document is laid out anew, with its comments") {
  SessionDriver talk;
  talk.say("// a ball\nball=sphere{radius:2,at:[0,1 ,0]} // round");
  talk.say("ball");
  talk.say("for i in 0..<3{\nbox{size:i+1} // one of three\n}");
  talk.say("// the end");
  CHECK(talk.session.formatted() ==
        "// a ball\nball = sphere { radius: 2, at: [0, 1, 0] } // round\nball\nfor i in 0..<3 {\n"
        "  box { size: i + 1 } // one of three\n}\n// the end\n");
}

TEST_CASE("session: a long document of unlike statements is what its text says after any change") {
  std::string text;
  for (int i = 0; i < 500; ++i)
    text += "r" + std::to_string(i) + " = 0.1 + " + std::to_string(i) + " / 5000\nsphere { radius: r" +
            std::to_string(i) + ", at: [" + std::to_string(i % 25) + ", " + std::to_string(i / 25) + ", 0] }\n";
  const Folder folder;
  SessionDriver talk;
  REQUIRE(talk.session.load(folder.write("long.rtl", text)).is_accepted);
  const auto check = [&talk] {
    const rt::lang::Loaded loaded = rt::lang::load_text(talk.session.text(), "document", ".", {});
    REQUIRE(loaded.scene);
    CHECK(loaded.scene->objects.size() == talk.session.scene().objects.size());
    CHECK(are_equal(picture(*loaded.scene), picture(talk.session.scene())));
  };
  const auto evaluated = [&talk] { return talk.session.counters().statements_evaluated; };
  std::uint64_t before = evaluated();
  talk.say("r250 = 0.9");
  CHECK(evaluated() == before + 2); // itself, and what uses it
  check();
  talk.say("box { size: r499 }");
  before = evaluated();
  talk.say(".move(z: 2)");
  CHECK(evaluated() == before + 1);
  talk.say("r3 = r400 * 2"); // moves behind what it needs now
  check();
  talk.say("sphere {}");
  REQUIRE(talk.session.undo());
  REQUIRE(talk.session.undo());
  CHECK(talk.session.text().find("\nr3 = 0.1 + 3 / 5000\n") != std::string::npos);
  check();
  talk.say("background: navy");
  talk.say("camera { at: [12, 10, 30], look_at: [12, 10, 0] }");
  talk.say("camera { at: [12, 10, 40], look_at: [12, 10, 0] }");
  CHECK(talk.session.scene().camera.at.z == 40);
  check();
  const SessionResult refused = talk.refuse("sphere { radius: r0250 }");
  CHECK(refused.diagnostics.front().label.find("did you mean `r") != std::string::npos);
  CHECK(talk.session.diff(0, talk.session.version()).find("+ r7 = ") != std::string::npos);
}

TEST_CASE("session: most of a scene of many unlike things stays in stretches that are kept") {
  std::string text;
  for (int i = 0; i < 5000; ++i)
    text += "n" + std::to_string(i) + " = sphere { radius: 0.1 }\nn" + std::to_string(i) + "\n";
  const Folder folder;
  SessionDriver talk;
  REQUIRE(talk.session.load(folder.write("many.rtl", text)).is_accepted);
  const auto before = talk.session.ranges();
  const auto held = [](const std::vector<rt::lang::SceneRange>& ranges) {
    std::uint32_t sum = 0;
    for (const auto& range : ranges) sum += range.end - range.begin;
    return sum;
  };
  CHECK(held(before) > 5000 - 400);
  talk.say("box {}");
  const auto after = talk.session.ranges();
  REQUIRE(after.size() == before.size());
  for (std::size_t i = 0; i < before.size(); ++i) CHECK(after[i].stamp == before[i].stamp);
  // A change in the middle makes anew what it is in, and nothing else.
  REQUIRE(talk.session.set("n1500.radius", "0.2").is_accepted);
  const auto changed = talk.session.ranges();
  std::uint32_t kept = 0;
  for (const auto& range : changed)
    for (const auto& old : before)
      if (old.stamp == range.stamp) kept += range.end - range.begin;
  CHECK(kept > 2500);
}
