// Any bytes at all must parse to a tree and diagnostics that keep their promises.
//   cmake --preset fuzz && cmake --build --preset fuzz --target fuzz_parse
//   build/fuzz/tests/fuzz_parse -dict=tests/fuzz/scene.dict CORPUS examples tests/golden/diagnostics

#include "lang/syntax/parse.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace {

using namespace rt::lang;

void require(bool claim) {
  if (!claim) std::abort();
}

void check_spans(const Ast& ast, const SourceMap& sources) {
  const std::size_t size = sources.file(ast.file).text.size();
  for (const Node& node : ast.nodes) require(node.begin <= node.end && node.end <= size);
}

void check(const Parsed& parsed, const SourceMap& sources, const SymbolTable& symbols) {
  require(parsed.ast.root != no_node);
  check_spans(parsed.ast, sources);
  require(!dump(parsed.ast, sources, symbols).empty());
  require(equal(parsed.ast, symbols, parsed.ast, symbols));
  for (const Diagnostic& diagnostic : parsed.diagnostics) {
    require(find_code(diagnostic.code).has_value());
    require(!render(diagnostic, sources, true).empty());
  }
  require(!render_json(parsed.diagnostics, sources).empty());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SourceMap sources;
  SymbolTable symbols;
  const std::string text(data, data + size);
  const FileId file = sources.add("fuzz.rtl", "", text);
  const Parsed plain = parse(sources, file, symbols, {.is_session = true});
  const Parsed folded = parse(sources, file, symbols, {.folds_repeats = true, .is_session = true});
  check(plain, sources, symbols);
  check(folded, sources, symbols);
  require(std::equal(plain.diagnostics.begin(), plain.diagnostics.end(), folded.diagnostics.begin(),
                     folded.diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.code == b.code && a.span == b.span; }));
  check(parse_expression(sources, file, symbols), sources, symbols);
  is_complete(text);
  return 0;
}
