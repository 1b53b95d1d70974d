#include "lang/ide/complete.hpp"
#include "tests/support/marked_text.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace rt::lang;
using rt::tests::MarkedText;

namespace {

// What is offered at the mark: of a file, as an editor would ask.
WordCompletion offered(std::string_view marked) {
  const MarkedText scene(marked);
  const Analysis analysis = analyse_text(scene.text, "scene.rtl", ".", {});
  return complete(analysis, 0, scene.places.at(0));
}

bool has(const WordCompletion& completion, std::string_view word) {
  return std::find(completion.words.begin(), completion.words.end(), word) != completion.words.end();
}

std::size_t place_of(const WordCompletion& completion, std::string_view word) {
  return static_cast<std::size_t>(std::find(completion.words.begin(), completion.words.end(), word) -
                                  completion.words.begin());
}

TEST_CASE("complete: at a place of a file, what its names are copies of says what their blocks take") {
  CHECK(offered("ball = sphere { radius: 2 }\nbig = ball.move(x: 1)\nbig { ra‸ }\n").words ==
        std::vector<std::string>{"radius"});
  CHECK(offered("def table(width = 2, depth = 1) { box {} }\ntable { wi‸ }\n").words ==
        std::vector<std::string>{"width"});
  CHECK(offered("mine = glass { col‸ }\n").words == std::vector<std::string>{"color"});
  CHECK(offered("ball = sphere {}\nfn ballast() = 1\nb‸\n").words.size() > 2);
  CHECK(has(offered("ball = sphere {}\nfn ballast() = 1\nb‸\n"), "ballast"));
  CHECK(offered("a = b {}\nb = a {}\na { ‸ }\n").begin > 0); // a mistake, and no endless search
}

TEST_CASE("complete: a text with errors in it is completed as far as it goes") {
  CHECK(offered("ball = sphere { raduis: 3 }\n= 7\nball { ra‸\n").words == std::vector<std::string>{"radius"});
  CHECK(offered("sphere { material: corn‸").words == std::vector<std::string>{"cornflowerblue", "cornsilk"});
}

TEST_CASE("complete: properties of the block come before things, and things before functions") {
  const WordCompletion all = offered("stone = box {}\ngroup { ‸ }\n");
  CHECK(place_of(all, "visible") < place_of(all, "box"));
  CHECK(place_of(all, "stone") < place_of(all, "abs"));
  CHECK(place_of(all, "sphere") < place_of(all, "abs"));
  CHECK(place_of(all, "abs") < all.words.size());
}

TEST_CASE("complete: the path of a file is no word") {
  const WordCompletion path = offered("include \"shapes/cr‸");
  CHECK(path.is_path);
  CHECK(path.words.empty());
  CHECK(path.begin == 9); // behind the quote
  CHECK_FALSE(offered("name = \"shapes/cr‸").is_path);
}

} // namespace
