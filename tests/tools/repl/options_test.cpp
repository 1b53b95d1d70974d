#include "tools/repl/options.hpp"

#include <catch2/catch.hpp>

using namespace rt::tools;

namespace {

TEST_CASE("options of a command: they are taken out, wherever they stand") {
  bool all = false;
  int depth = 0;
  std::vector<std::string> ray;
  std::vector<std::string> words{"3", "--all", "--ray", "-1,0,0", "0,0,1", "4", "--depth", "2"};
  CHECK(take_options(words, std::vector<CommandOption>{{"all", &all}, {"depth", &depth}, {"ray", &ray, 2}}) == "");
  CHECK(words == std::vector<std::string>{"3", "4"});
  CHECK(all);
  CHECK(depth == 2);
  CHECK(ray == std::vector<std::string>{"-1,0,0", "0,0,1"});
}

TEST_CASE("options of a command: what is wrong with them is said") {
  rt::tools::live::PictureSettings settings;
  std::optional<int> depth;
  std::optional<double> least;
  std::vector<CommandOption> options = picture_options(settings);
  options.push_back({"depth", &depth});
  options.push_back({"least", &least});
  const auto problem = [&](std::vector<std::string> words) { return take_options(words, options); };
  CHECK(problem({"--sizes", "3x3"}) == "unknown option `--sizes`; did you mean `--size`?");
  CHECK(problem({"--size"}) == "--size takes a value");
  CHECK(problem({"--size", "3"}) == "--size takes width and height, as in 800x600, not `3`");
  CHECK(problem({"--max-depth", "2"}) == "");
  CHECK(settings.max_depth == 2);
  CHECK(problem({"--depth", "-2"}) == "--depth takes a whole number, not `-2`");
  CHECK(problem({"--least", "0.25"}) == "");
  CHECK(least == 0.25);
  CHECK(problem({"--least", "1.5"}) == "--least takes a number from 0 to 1, not `1.5`");
  CHECK(problem({"--least", "much"}) == "--least takes a number from 0 to 1, not `much`");
}

} // namespace
