#include "tests/support/parsing.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace rt::lang;
using rt::tests::parse_text;
using rt::tests::shape;
using rt::tests::Text;

namespace {

const ParseOptions folding{.folds_repeats = true};

/// The items of the file's block and of groups in it one by one, and where each stands in the text.
struct Items {
  std::vector<std::string> shapes;
  std::vector<std::string> texts;
  std::size_t repeats = 0;
};

void add_items(Text& text, NodeId block, Items& out) {
  Ast& ast = text.parsed.ast;
  const auto add = [&](NodeId id) {
    if (ast.kind(id) == Kind::override_ && shape(ast, text.symbols, ast.override_(id).base) == "group")
      return add_items(text, ast.override_(id).block, out);
    out.shapes.push_back(shape(ast, text.symbols, id));
    out.texts.emplace_back(text.sources.text(ast.span(id)));
  };
  const NodeList children = ast.children(block);
  for (const NodeId id : std::vector<NodeId>(children.begin(), children.end())) {
    if (ast.kind(id) != Kind::repeat) {
      add(id);
      continue;
    }
    ++out.repeats;
    const Repeat repeat = ast.repeat(id);
    for (std::uint32_t i = 0; i < repeat.count; ++i) {
      ast.become(repeat, i);
      add(repeat.model);
    }
  }
}

Items items(Text& text) {
  Items out;
  add_items(text, text.parsed.ast.root, out);
  return out;
}

/// Folding must not change what a text says; gives the number of repeats.
std::size_t check_folding(const std::string& scene) {
  Text plain = parse_text(scene), folded = parse_text(scene, folding);
  CHECK(plain.codes() == folded.codes());
  const Items expected = items(plain), found = items(folded);
  CHECK(expected.shapes == found.shapes);
  CHECK(expected.texts == found.texts);
  CHECK(expected.repeats == 0);
  const Items again = items(folded); // `become` may be called in any order, any number of times
  CHECK(expected.shapes == again.shapes);
  return found.repeats;
}

std::string spheres(int count, std::string_view rest = "") {
  std::string out;
  for (int i = 0; i < count; ++i) {
    out += "sphere { at: [" + std::to_string(i) + ", -0.5, 1e-3], radius: " + std::to_string(i) + ".25" +
           std::string(rest) + " }\n";
  }
  return out;
}

} // namespace

TEST_CASE("repeats: items of the same wording share one tree, and say what they said") {
  CHECK(check_folding(spheres(1000)) == 1);
  CHECK(check_folding(spheres(1000, ", material: red")) == 1);
  CHECK(check_folding(spheres(100, ", material: material { color: #123 }")) == 1);
  CHECK(check_folding(spheres(100, ", name: \"ball\"")) == 1);
  const Text text = parse_text(spheres(1000), folding);
  CHECK(text.ast().nodes.size() < 200);
  CHECK(text.ast().repeats[0].is_first);
  CHECK(text.ast().repeats[0].numbers_each == 4);
}

TEST_CASE("repeats: colours vary as numbers do") {
  std::string scene;
  for (int i = 0; i < 200; ++i) {
    scene += "box { size: " + std::to_string(i) + ", material: #" + std::to_string(100 + i) + " }\n";
  }
  CHECK(check_folding(scene) == 1);
}

TEST_CASE("repeats: wordings may take turns") {
  std::string scene;
  std::mt19937 random(3);
  const char* const materials[] = {"red", "green", "blue"};
  for (int i = 0; i < 300; ++i) {
    scene += "sphere { radius: " + std::to_string(i) + ", material: " + materials[random() % 3] + " }\n";
    if (i % 7 == 0) scene += "box { size: [1, 2, " + std::to_string(i) + "] }.rotate(y: 30)\n";
  }
  CHECK(check_folding(scene) > 100);
}

TEST_CASE("repeats: other words, other operators, other lengths and other strings are other items") {
  CHECK(check_folding(spheres(20) + "sphere { at: [1, 2], radius: 1 }\nsphere { at: [1, 2, 3], radius: 1 }\n") == 2);
  CHECK(check_folding(spheres(20) + "sphere { radius: 1, at: [1, 2, 3] }\n") == 1);
  std::string named;
  for (int i = 0; i < 200; ++i) named += "sphere { name: \"s" + std::to_string(i) + "\", radius: 1 }\n";
  CHECK(check_folding(named) == 0);
  std::string sums;
  for (int i = 0; i < 40; ++i) sums += std::string("sphere { radius: 1 ") + (i % 2 == 0 ? "+" : "*") + " x }\n";
  CHECK(check_folding(sums) > 2);
}

TEST_CASE("repeats: a declaration ends what can be repeated, because names may mean something else behind it") {
  const std::string declared = spheres(20, ", material: red") + "red = blue\n" + spheres(20, ", material: red");
  CHECK(check_folding(declared) == 2);
  const Text text = parse_text(declared, folding);
  REQUIRE(text.ast().repeats.size() == 2);
  CHECK(text.ast().repeats[0].model != text.ast().repeats[1].model);
  CHECK(check_folding(spheres(20) + "x = = 1\n" + spheres(20)) == 2); // even a broken one
}

TEST_CASE("repeats: what has a scope or binds names is never shared") {
  std::string scene;
  for (int i = 0; i < 40; ++i) scene += "group { r = " + std::to_string(i) + "; sphere { radius: r } }\n";
  for (int i = 0; i < 40; ++i) scene += "sphere { points: [x * " + std::to_string(i) + " for x in 0..3] }\n";
  CHECK(check_folding(scene) == 0);
}

TEST_CASE("repeats: short blocks stay as they are, long ones within a thing are folded too") {
  CHECK(check_folding(spheres(10)) == 0);
  const Text text = parse_text("union {\n" + spheres(500) + "}\ngroup {\n" + spheres(3) + "}\n", folding);
  CHECK(text.codes().empty());
  CHECK(text.ast().repeats.size() == 1);
  CHECK(text.ast().repeats[0].count > 480);
}

TEST_CASE("repeats: errors in the middle are found and cost only their item") {
  const std::string scene = spheres(30) + "sphere { radius 1 }\n" + spheres(30) + "sphere { radius: }\n" + spheres(30);
  CHECK(parse_text(scene, folding).codes() == std::vector<std::string>{"E0102", "E0101"});
  check_folding(scene);
}

TEST_CASE("repeats: what only looks like an item of the same wording is read as what it is") {
  // Each stands among items that repeat `sphere { at: [1, -2, 3.5], radius: 1 }` by their text alone.
  const char* const others[] = {
      "sphere { at: [1, 2, 3], radius: 1 }.at(1, 2, 3)",
      "sphere { at: [1, 2, 3], radius: 1 }\n  .at(1, 2, 3)",
      "sphere { at: [1, 2, 3], radius: 1 }\n\n // a comment\n  .at(1, 2, 3)",
      "sphere { at: [1, 2, 3], radius: 1 } { radius: 2 }",
      "sphere { at: [1, 2, 3], radius: 1 }\n{ radius: 2 }", // an error
      "sphere { at: [1, 2, 3], radius: 1 } | box {}",
      "sphere { at: [1, 2, 3], radius: 1 } // a comment",
      "sphere { at: [1, 2, 3], radius: 1 } # no comment",
      "sphere { at: [1, 2, 3], radius: 1 }; sphere { at: [4, 5, 6], radius: 1 }",
      "sphere { at: [1, 2, 3], radius: 1 }, sphere { at: [4, 5, 6], radius: 1 }",
      "sphere { at: [1, 2, 3], radius: 1 } sphere { at: [4, 5, 6], radius: 1 }", // an error
      "sphere { at: [1, 2, 3], radius: 1 }   \r",
      "sphere { at: [1, 2, 3], radius: 1 }}", // an error
      "sphere { at: [1, 2, 3], radius: 1e2 }",
      "sphere { at: [1, 2, 3], radius: 1E-2 }",
      "sphere { at: [1, 2, 3], radius: 1e }",    // an error
      "sphere { at: [1, 2, 3], radius: 1e999 }", // an error
      "sphere { at: [1, 2, 3], radius: 1. }",    // an error
      "sphere { at: [1, 2, 3], radius: .5 }",    // an error
      "sphere { at: [1, 2, 3], radius: 0x10 }",  // an error
      "sphere { at: [1, 2, 3], radius: 1_000 }", // an error
      "sphere { at: [1, 2, 3], radius: 1turn }",
      "sphere { at: [1, 2, 3], radius: 1.5.x }",
      "sphere { at: [1, 2, 3], radius: 1..2 }",
      "sphere { at: [1, 2, 3], radius: 1 + 2 }",
      "sphere { at: [1, 2, 3], radius: 1 - 2 }",
      "sphere { at: [1, 2, 3], radius: -1 }",
      "sphere { at: [1, 2, 3], radius: - 1 }",
      "sphere { at: [1, 2, 3], radius: --1 }",
      "sphere { at: [1, 2, 3], radius: -2^2 }",
      "sphere { at: [1 -2, 3], radius: 1 }",
      "sphere { at: [1\n, -2, 3], radius: 1 }",
      "sphere { at: [1\n-2, 3], radius: 1 }",
      "sphere { at: [0.30000000000000000000000000000001, 123456789012345678901234567890, -0], radius: 1 }",
  };
  for (const char* other : others) {
    INFO(other);
    check_folding(spheres(20) + other + "\n" + spheres(20));
    check_folding("group {\n" + spheres(20) + other + "\n" + spheres(3) + other + "}\n");
    check_folding("group {\n" + spheres(20) + "  " + other); // the end of the file, in an open brace
  }
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    std::string scene = spheres(20);
    for (int i = 0; i < 40; ++i)
      scene += random() % 2 == 0 ? spheres(1) : others[random() % std::size(others)] + std::string("\n");
    check_folding(scene);
  }
}

TEST_CASE("repeats: a number whose next line begins with a dot is part of something") {
  const std::string begin = "group { " + spheres(20);
  for (const char* form : {"s { x, @\n.y }\n", "s { x: p[@\n .y] }\n", "s { x: @\n.y }\n", "s { x: [1, @\n\n.y] }\n",
                           "s { x, @\n{} }\n"}) {
    for (const char* numbers : {"111-1", "-1-1-11", "-0-01", "00-0", "1111"}) {
      std::string scene = begin;
      for (const char* c = numbers; *c != 0; ++c) {
        std::string item = form, number(1, *c);
        if (*c == '-') number += *++c;
        scene += item.replace(item.find('@'), 1, number);
      }
      INFO(scene);
      check_folding(scene + "}\n");
    }
  }
}

TEST_CASE("repeats: what a record must not hold is reported item by item, or once where it holds nothing else") {
  std::string items;
  for (int i = 0; i < 24; ++i) items += "sphere { at: [" + std::to_string(i) + ", 0, 0] }\n";
  CHECK(parse_text("r = {\nx: 1\n" + items + "}\n", folding).codes() == std::vector<std::string>(24, "E0132"));
  CHECK(parse_text("r = {\n" + items + "}\n", folding).codes() == std::vector<std::string>{"E0132"});
}

TEST_CASE("repeats: wordings that part late, early, and not at all") {
  std::mt19937 random(17);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::string> forms;
    for (int form = 0; form < 8; ++form) {
      std::string text = "s { ";
      for (int i = 0, n = 1 + static_cast<int>(random() % 4); i < n; ++i) {
        text += random() % 4 == 0 ? "b" : "a";
        text += random() % 3 == 0 ? ": [@, @], " : ": @, ";
      }
      forms.push_back(text + (random() % 2 == 0 ? "c: x }\n" : "}\n"));
    }
    std::string scene = spheres(16);
    for (int i = 0; i < 60; ++i) {
      std::string item = forms[random() % forms.size()];
      for (std::size_t at = 0; (at = item.find('@')) != std::string::npos;)
        item.replace(at, 1, std::to_string(static_cast<int>(random() % 100) - 50));
      scene += item;
    }
    check_folding(scene);
  }
}

TEST_CASE("repeats: any item may be the first of its wording") {
  const char* const firsts[] = {
      "sphere { radius: -1 }",
      "sphere { radius: - 1 }",
      "sphere { radius: 2 - 1 }",
      "sphere { radius: -2 ^ 2 }",
      "sphere { radius: (1) }",
      "sphere { radius: 1, name: \"a, 1\" }",
      "sphere { radius: 1 /* : 2 */ }",
      "sphere { radius: 1turn }",
      "sphere { at: [1, [2, -3], 4].x }",
      "sphere { radius: x1 }",
      "sphere { radius: 1; at: 2 }",
      "sphere {\n  radius: 1\n  at: [1,\n 2,\n -3]\n}",
      "a.b { x: 1, y: c.d2, z: [1, 2] }",
      "sphere { radius: 1 && 2 }",
      "sphere { points: [1\n -2] }",
      "sphere { radius: [1][0] }",
      "sphere { radius: 1 }{ radius: 2 }",
      "sphere { color: #123, radius: 1 }",
  };
  for (const char* first : firsts) {
    INFO(first);
    std::string scene = spheres(20), again;
    for (int i = 0; i < 10; ++i) {
      std::string item = first;
      for (char& c : item)
        if (c == '1' || c == '2') c = static_cast<char>('1' + i % 9);
      scene += item + "\n";
      again += item + "; ";
    }
    check_folding(scene);
    check_folding(scene + again);
    check_folding(scene + "x = 1\n" + again + "\n" + scene);
  }
}
