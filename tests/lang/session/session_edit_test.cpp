#include "tests/support/session_driver.hpp"

using rt::lang::SessionResult;
using namespace rt::tests;

TEST_CASE("session: properties of named things are set in their text") {
  SessionDriver talk;
  talk.say("ball = sphere {}");
  talk.say("ball");
  REQUIRE(talk.session.set("ball.radius", "2").is_accepted);
  CHECK(talk.radius(0) == 2);
  REQUIRE(talk.session.set("ball.radius", "3").is_accepted);
  REQUIRE(talk.session.set("ball.at", "[1, 2, 3]").is_accepted);
  CHECK(talk.session.text() == "ball = sphere { radius: 3, at: [1, 2, 3] }\nball\n");
  talk.say("box { name: \"crate\" }.rotate(y: 45)");
  REQUIRE(talk.session.set("crate.size", "4").is_accepted);
  CHECK(talk.session.text().find("box { name: \"crate\", size: 4 }.rotate(y: 45)") != std::string::npos);
  talk.say("wood = rgb(0.5, 0.3, 0.1)");
  talk.say("camera {\n  at: [0, 1, 9]\n}");
  REQUIRE(talk.session.set("camera.fov", "30").is_accepted);
  CHECK(talk.session.text().find("camera {\n  at: [0, 1, 9]\n  fov: 30\n}") != std::string::npos);
  CHECK(talk.session.scene().camera.fov == 30);
  REQUIRE(talk.session.set("background", "red").is_accepted);
  CHECK(talk.session.scene().background == rt::Color{1, 0, 0});
  CHECK_FALSE(talk.session.set("nobody.radius", "2").is_accepted);
  CHECK_FALSE(talk.session.set("ball.raduis", "2").is_accepted);
  CHECK_FALSE(talk.session.set("ball.radius", "-2").is_accepted);
  CHECK(talk.radius(0) == 3);
}

TEST_CASE("session: a name that is bound is set to another value") {
  SessionDriver talk;
  talk.say("r = 2");
  talk.say("sphere { radius: r }");
  REQUIRE(talk.session.set("r", "3").is_accepted);
  CHECK(talk.radius(0) == 3);
  CHECK(talk.session.text() == "r = 3\nsphere { radius: r }\n");
  talk.say("def ball(r = 1) { sphere { radius: r } }");
  const SessionResult refused = talk.session.set("ball.r", "2");
  CHECK(refused.problem == "`ball` is a declaration, not a thing");
  CHECK(refused.advice.size() == 1);
}

TEST_CASE("session: what others use is not removed") {
  SessionDriver talk;
  talk.say("ball = sphere {}");
  talk.say("ball { at: [0, 1, 0] }");
  const SessionResult refused = talk.session.remove("ball");
  CHECK_FALSE(refused.is_accepted);
  CHECK(refused.problem == "`ball` cannot be removed: it is used");
  REQUIRE(refused.advice.size() == 1);
  CHECK(refused.advice.front() == "by `ball { at: [0, 1, 0] }`");
  talk.say("box { name: \"crate\" }");
  REQUIRE(talk.session.remove("crate").is_accepted);
  CHECK(talk.count() == 1);
  talk.say("n = 3");
  REQUIRE(talk.session.remove("n").is_accepted);
  talk.refuse("n");
  CHECK_FALSE(talk.session.remove("nobody").is_accepted);
}

TEST_CASE("session: a thing without a name is found by its noun, if it is the only one") {
  SessionDriver talk;
  talk.say("sphere {}");
  REQUIRE(talk.session.set("sphere.radius", "2").is_accepted);
  CHECK(talk.radius(0) == 2);
  talk.say("sphere { at: [3, 0, 0] }");
  const SessionResult which = talk.session.set("sphere.radius", "3");
  CHECK(which.problem == "there are 2 of `sphere`; which one?");
  CHECK(which.advice == std::vector<std::string>{"use its number from :list instead of the name: 1, 2"});
  CHECK(talk.session.remove("sphere").problem == "there are 2 of `sphere`; which one?");
  talk.say("crate = box {}");
  CHECK(talk.session.remove("crat").problem == "there is nothing called `crat`; did you mean `crate`?");
  CHECK(talk.session.text_of("crate") == "crate = box {}");
  CHECK(talk.session.text_of("sphere").empty());
}

TEST_CASE("session: things are listed with name, kind and place") {
  SessionDriver talk;
  talk.say("ball = sphere {}");
  talk.say("ball { at: [1, 2, 3] }");
  talk.say("def table() { box {} }");
  talk.say("table");
  talk.say("for i in 0..2 { sphere { name: \"bead\" } }");
  talk.say("plane {}");
  talk.say("sun { direction: [0, -1, 0] }");
  const auto listed = talk.session.objects();
  REQUIRE(listed.size() == 5);
  CHECK(listed[0].name == "ball");
  CHECK(listed[0].kind == "sphere");
  CHECK(listed[0].place == "around [1, 2, 3]");
  CHECK(listed[0].first_number == 0); // it has a name
  CHECK(listed[1].kind == "table");
  CHECK(listed[1].first_number == 1);
  CHECK(listed[1].last_number == 1);
  CHECK(listed[2].name == "bead");
  CHECK(listed[2].count == 3);
  CHECK(listed[3].place == "endless");
  CHECK(listed[3].first_number == 2);
  CHECK(listed[4].kind == "sun");
  CHECK(listed[4].first_number == 3);
}

TEST_CASE("session: what has no name is set and removed by the number that the list shows") {
  SessionDriver talk;
  talk.say("ball = sphere {}");
  talk.say("ball");
  talk.say("plane {}");
  talk.say("sphere { at: [3, 0, 0] }");
  talk.say("camera { at: [0, 1, 9] }");
  REQUIRE(talk.session.set("2.radius", "3").is_accepted);
  CHECK(talk.radius(2) == 3);
  CHECK(talk.session.model_of("2") == "sphere");
  REQUIRE(talk.session.set("3.fov", "25").is_accepted);
  CHECK(talk.session.scene().camera.fov == 25);
  REQUIRE(talk.session.remove("1").is_accepted);
  CHECK(talk.session.text() ==
        "ball = sphere {}\nball\nsphere { at: [3, 0, 0], radius: 3 }\ncamera { at: [0, 1, 9], fov: 25 }\n");
  // What follows moved up.
  CHECK(talk.session.model_of("1") == "sphere");
  const SessionResult refused = talk.session.remove("7");
  CHECK(refused.problem == "there is no thing number 7");
  CHECK(refused.advice == std::vector<std::string>{":list goes up to 2"});
}

TEST_CASE("session: a loop has one number, and is removed as a whole") {
  SessionDriver talk;
  talk.say("for i in 0..9 { sphere { at: [i, 0, 0] }, box { at: [i, 1, 0] } }");
  const auto listed = talk.session.objects();
  REQUIRE(listed.size() == 20);
  CHECK(listed[19].first_number == 1);
  CHECK(talk.session.set("1.radius", "3").problem.starts_with("`for i in 0..9 "));
  REQUIRE(talk.session.remove("1").is_accepted);
  CHECK(talk.session.is_empty());
}

TEST_CASE("session: things written so much alike that they are kept together have a number each") {
  const Folder folder;
  std::string text = "plane {}\n";
  for (int i = 1; i <= 40; ++i) text += "sphere { at: [" + std::to_string(i) + ", 0, 0] }\n";
  SessionDriver talk;
  REQUIRE(talk.session.load(folder.write("many.rtl", text)).is_accepted);
  CHECK(talk.session.objects().back().last_number == 41);
  REQUIRE(talk.session.objects().size() < 41); // or the test would be about nothing
  // The thirty-first sphere, behind the plane.
  REQUIRE(talk.session.set("32.radius", "3").is_accepted);
  CHECK(talk.radius(31) == 3);
  CHECK(talk.at(31) == rt::Vec3{31, 0, 0});
  CHECK(talk.radius(30) == 1);
  REQUIRE(talk.session.remove("41").is_accepted);
  CHECK(talk.count() == 40);
  CHECK(talk.at(39) == rt::Vec3{39, 0, 0});
}
