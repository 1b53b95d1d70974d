#include "renderer/math/random.hpp"
#include "tools/lsp/line_edits.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tools::lsp;

namespace {

std::string applied(std::string text, const std::vector<Edit>& edits) {
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
    text.replace(edit->begin, edit->end - edit->begin, edit->text);
  return text;
}

} // namespace

TEST_CASE("line edits: only the lines that differ are touched") {
  const auto edits = line_edits("a\nb\nc\nd\ne\n", "a\nB\nc\nd\n\ne\n");
  REQUIRE(edits.size() == 2);
  CHECK(edits[0].begin == 2);
  CHECK(edits[0].end == 4);
  CHECK(edits[0].text == "B\n");
  CHECK(edits[1].begin == 8);
  CHECK(edits[1].end == 8);
  CHECK(edits[1].text == "\n");
  CHECK(line_edits("same\n", "same\n").empty());
}

TEST_CASE("line edits: applied to the one text they give the other") {
  SplitMix64 random(7);
  const auto text = [&] {
    std::string all;
    for (std::uint64_t lines = random.bits() % 12; lines > 0; --lines) {
      all += static_cast<char>('a' + random.bits() % 4);
      if (lines > 1 || random.bits() % 2 == 0) all += '\n'; // the last line may have no end
    }
    return all;
  };
  for (int i = 0; i < 5000; ++i) {
    const std::string before = text(), after = text();
    INFO(before << "---\n" << after);
    const auto edits = line_edits(before, after);
    REQUIRE(applied(before, edits) == after);
    for (std::size_t k = 1; k < edits.size(); ++k) REQUIRE(edits[k - 1].end < edits[k].begin);
  }
}

TEST_CASE("line edits: texts of which no line is the other's, however long, are one edit") {
  std::string before, after;
  for (int i = 0; i < 30'000; ++i) before += "a\n", after += "b\n";
  const auto edits = line_edits(before, after);
  CHECK(edits.size() == 1);
  CHECK(applied(before, edits) == after);
}
