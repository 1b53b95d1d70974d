#include "lang/syntax/parse.hpp"

#include "lang/syntax/grammar.hpp"
#include "lang/syntax/grammar_actions.hpp"
#include "lang/syntax/grammar_analysis.hpp"
#include "lang/syntax/grammar_errors.hpp"
#include "lang/syntax/grammar_item_actions.hpp"
#include "lang/text/tokens.hpp"
#include "lang/text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {

namespace {

using Input = tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy, tao::pegtl::eol::lf, const char*>;

// The whole text becomes one error node.
void give_up(ParseState& state) {
  const auto end = static_cast<std::uint32_t>(state.text.size());
  state.build.restore({});
  state.build.leaf(Kind::error, 0, end, static_cast<std::uint32_t>(no_symbol));
}

std::optional<Diagnostic> not_utf8(const SourceFile& source, FileId file) {
  const std::optional<std::size_t> at = find_invalid_utf8(source.text);
  if (!at) return std::nullopt;
  const auto begin = static_cast<std::uint32_t>(*at);
  const auto byte = static_cast<unsigned char>(source.text[*at]);
  return errors::not_utf8({file, begin, begin + 1}, fmt::format("the byte 0x{:02x} here is not UTF-8", byte),
                          "save the file in the encoding UTF-8");
}

template <typename Rule>
bool match(ParseState& state, std::uint32_t begin) {
  Input in(state.text.data(), state.text.data() + state.text.size(), "");
  in.bump(begin);
  try {
    tao::pegtl::parse<Rule, grammar::action, grammar::control>(in, state);
    return true;
  } catch (const SyntaxError&) {
    give_up(state);
  } catch (const TooDeep& deep) {
    state.too_deep(deep.begin, deep.end);
    give_up(state);
  }
  return false;
}

void sort_by_place(std::vector<Diagnostic>& diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.span.begin < b.span.begin; });
}

template <typename Rule>
Parsed parse_as(const SourceMap& sources, FileId file, SymbolTable& symbols, const ParseOptions& options) {
  Parsed parsed;
  const SourceFile& source = sources.file(file);
  ParseState state(sources, file, symbols, options, parsed.ast);
  const std::uint32_t begin = source.line_starts[0];
  const auto end = static_cast<std::uint32_t>(source.text.size());
  constexpr bool is_file = std::is_same_v<Rule, grammar::file>;
  if constexpr (is_file) state.build.open(begin);
  if (auto wrong = not_utf8(source, file)) {
    state.diagnostics.push_back(*std::move(wrong));
    give_up(state);
    if constexpr (is_file) state.build.open_suffix();
  } else if (!match<Rule>(state, begin) && is_file) {
    state.build.open_suffix();
  }
  if constexpr (is_file) state.build.close_children(Kind::block, end);
  parsed.ast.root = state.build.top().node;
  parsed.diagnostics = std::move(state.diagnostics);
  sort_by_place(parsed.diagnostics);
  return parsed;
}

} // namespace

Parsed parse(const SourceMap& sources, FileId file, SymbolTable& symbols, const ParseOptions& options) {
  return parse_as<grammar::file>(sources, file, symbols, options);
}

Parsed parse_expression(const SourceMap& sources, FileId file, SymbolTable& symbols, const ParseOptions& options) {
  return parse_as<grammar::single_expression>(sources, file, symbols, options);
}

std::size_t grammar_problems() {
  return tao::pegtl::analyze<grammar::file>() + tao::pegtl::analyze<grammar::single_expression>();
}

bool is_complete(std::string_view text) {
  std::size_t open = 0;
  Token last{TokenKind::newline, 0, 0};
  for (Token token = next_token(text, 0); token.kind != TokenKind::end; token = next_token(text, token.end)) {
    const std::string_view said = text_of(text, token);
    if (token.kind == TokenKind::block_comment && (said.size() < 4 || !said.ends_with("*/"))) return false;
    if (token.kind == TokenKind::open) ++open;
    if (token.kind == TokenKind::close && open > 0) --open;
    const bool is_space = token.kind == TokenKind::newline || token.kind == TokenKind::line_comment ||
                          token.kind == TokenKind::block_comment;
    if (!is_space) last = token;
  }
  if (open > 0) return false;
  if (last.kind == TokenKind::symbol) return false;
  if (last.kind == TokenKind::separator) return text_of(text, last) == ";";
  if (last.kind != TokenKind::name) return true;
  const Word word = classify(text_of(text, last));
  return !is_reserved(word) || word == Word::true_ || word == Word::false_ || word == Word::none_;
}

} // namespace rt::lang
