#include "lang/syntax/parse_state.hpp"

#include "lang/text/characters.hpp"
#include "lang/text/literals.hpp"
#include "lang/text/tokens.hpp"

#include <algorithm>

namespace rt::lang {

namespace {

constexpr std::size_t most_errors = 100;    // beyond that it is not a scene
constexpr std::uint32_t tree_depth = 2'000; // of operators in a row, as a | b | c; brackets have their own limit

} // namespace

ParseState::ParseState(const SourceMap& sources, FileId source, SymbolTable& table, const ParseOptions& parse_options,
                       Ast& ast)
    : text(sources.file(source).text), file(source), symbols(table), options(parse_options), build(ast, tree_depth),
      folder_(build) {
  ast.file = source;
  // Enough for most texts; untouched pages cost nothing.
  ast.nodes.reserve(text.size() / 8 + 64);
  ast.constants.reserve(text.size() / 16 + 64);
  ast.repeat_spans.reserve(text.size() / 64 + 64);
}

void ParseState::read_word(std::uint32_t begin, std::uint32_t end) {
  last = {classify(text.substr(begin, end - begin)), begin, end};
}

bool ParseState::word_is_primary() const {
  return !is_reserved(last.word) || last.word == Word::true_ || last.word == Word::false_ || last.word == Word::none_;
}

ParseState::Modes ParseState::enter(std::uint32_t at, char bracket) {
  deeper(at);
  const Modes before{newline_is_space_, block_may_follow_};
  open_.push_back({at, bracket});
  newline_is_space_ = bracket == '(';
  block_may_follow_ = true;
  return before;
}

void ParseState::leave(Modes modes) {
  shallower();
  open_.pop_back();
  newline_is_space_ = modes.newline_is_space;
  block_may_follow_ = modes.block_may_follow;
}

void ParseState::deeper(std::uint32_t at) {
  if (++depth_ <= options.max_depth) return;
  too_deep(at, at + 1);
  throw SyntaxError{at, true};
}

void ParseState::too_deep(std::uint32_t begin, std::uint32_t end) {
  add(errors::nested_too_deep(span(begin, end), "this is nested too deeply",
                              "give inner parts names, or use a list or a loop"));
}

ParseState::Closing ParseState::not_closed(std::uint32_t before, std::uint32_t at) {
  if (at >= text.size()) fail(Expected::closing_bracket, at);
  const OpenBracket bracket = open_.back();
  const char found = text[at];
  const bool is_closing = found == ')' || found == ']' || found == '}';
  const char opening = found == ')' ? '(' : found == ']' ? '[' : '{';
  const bool closes_outer = is_closing && std::any_of(open_.begin(), open_.end() - 1,
                                                      [&](OpenBracket outer) { return outer.bracket == opening; });
  const bool is_on_new_line = text.substr(before, at - before).find('\n') != std::string_view::npos;
  if (closes_outer || (!is_closing && is_on_new_line)) {
    report(unclosed_bracket(file, bracket));
    return Closing::stay;
  }
  if (is_closing) {
    report(mismatched_bracket(file, bracket, at, found));
    return Closing::consume;
  }
  fail(Expected::closing_bracket, at);
}

void ParseState::add(Diagnostic diagnostic) {
  const bool is_known = std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& d) {
    return d.code == diagnostic.code && d.span == diagnostic.span; // a place may be tried more than once
  });
  if (!is_known) diagnostics.push_back(std::move(diagnostic));
}

void ParseState::report(Diagnostic diagnostic) {
  add(std::move(diagnostic));
  if (diagnostics.size() < most_errors) return;
  diagnostics.back().notes.push_back({std::nullopt, "too many errors: the rest of the file was not looked at"});
  throw SyntaxError{static_cast<std::uint32_t>(text.size()), true};
}

void ParseState::complain(Complaint complaint, std::uint32_t begin, std::uint32_t end) {
  if (complaint == Complaint::none) return;
  const bool has_left = complaint != Complaint::misplaced_not;
  const std::string_view left =
      has_left ? text.substr(build.top().begin, build.top().end - build.top().begin) : std::string_view{};
  report(misused_operator(complaint, span(begin, end), text.substr(begin, end - begin), left));
}

void ParseState::fail(Expected expected, std::uint32_t at) {
  const bool is_lexical = expected == Expected::string_end || expected == Expected::comment_end;
  const std::size_t rest = text.find_first_not_of(" \t\r\n", at);
  if (!is_lexical && rest == std::string_view::npos && !open_.empty()) fail_at_end();
  report(explain_failure(place(at), expected));
  throw SyntaxError{resume_after(text, at, diagnostics.back()), expected == Expected::comment_end};
}

// With a unit, perhaps erroneous.
void ParseState::number(std::uint32_t begin, std::uint32_t end) {
  const std::string_view literal_text = text.substr(begin, end - begin);
  const NumberLiteral literal = read_number(literal_text);
  double value = literal.value;
  if (auto wrong = malformed_number(span(begin, end), literal_text, literal.length, value)) {
    report(*std::move(wrong));
  } else if (literal.length != literal_text.size()) {
    value *= degrees_per(literal_text.substr(literal.length));
  }
  build.number(begin, end, value);
}

void ParseState::color(std::uint32_t begin, std::uint32_t end) {
  const std::string_view literal = text.substr(begin, end - begin);
  const std::string_view digits = literal.substr(1);
  const bool is_whole =
      (digits.size() == 3 || digits.size() == 6) && std::all_of(digits.begin(), digits.end(), is_hex_digit);
  if (!is_whole && begin == item_) fail(Expected::item, begin); // no item begins with a colour: a comment or directive
  if (!is_whole) report(malformed_color(span(begin, end), literal));
  build.leaf(Kind::color, begin, end, is_whole ? read_color(digits) : 0);
}

void ParseState::plus_sign(std::uint32_t begin, std::uint32_t end) {
  if (begin > 0 && text[begin - 1] == '+') {
    report(foreign_operator(span(begin - 1, end), "++"));
    throw SyntaxError{end};
  }
  build.prefix(Op::plus, begin);
}

// `location <0, 1, 2>` in a block: it is not a comparison.
bool ParseState::begins_foreign_vector(std::uint32_t at) const {
  const bool is_item = build.top().begin == item_ && (open_.empty() || open_.back().bracket == '{');
  if (!is_item) return false;
  Token token = next_token(text, at + 1);
  if (text_of(text, token) == "-" || text_of(text, token) == "+") token = next_token(text, token.end);
  return token.kind == TokenKind::number && text_of(text, next_token(text, token.end)) == ",";
}

void ParseState::infix_symbol(std::uint32_t begin, std::uint32_t end) {
  const std::string_view op = text.substr(begin, end - begin);
  const char second = op.size() > 1 ? op[1] : '\0';
  if (op == "...") report(foreign_operator(span(begin, end), op));
  if (op[0] == '.') return complain(build.range(op == "..<"), begin, end);
  if ((op[0] == '=' && second != '=') || (second == op[0] && op[0] != '='))
    report(foreign_operator(span(begin, end), op));
  if (op == "<" && begins_foreign_vector(begin)) fail(Expected::property_colon, begin);
  const auto apply = [&](Op meaning) { complain(build.infix(meaning), begin, end); };
  switch (op[0]) {
  case '=':
    return apply(Op::equal);
  case '!':
    return apply(Op::not_equal);
  case '<':
    return apply(second == '=' ? Op::less_equal : Op::less);
  case '>':
    return apply(second == '=' ? Op::greater_equal : Op::greater);
  case '+':
    return apply(Op::add);
  case '-':
    return apply(Op::subtract);
  case '|':
    return apply(second == '|' ? Op::or_ : Op::unite);
  case '&':
    return apply(second == '&' ? Op::and_ : Op::intersect);
  case '*':
    return apply(second == '*' ? Op::power : Op::multiply);
  case '/':
    return apply(Op::divide);
  case '%':
    return apply(Op::modulo);
  default:
    return apply(Op::power);
  }
}

void ParseState::infix_word(std::uint32_t begin, std::uint32_t end) {
  const Complaint complaint = last.word == Word::by_   ? build.step()
                              : last.word == Word::or_ ? build.infix(Op::or_)
                                                       : build.infix(Op::and_);
  complain(complaint, begin, end);
}

void ParseState::begin_items() {
  follows_line_ = false;
  folder_.open_block();
}

void ParseState::close_block(std::uint32_t end) {
  folder_.close_block();
  build.close_children(Kind::block, end);
}

void ParseState::close_list(std::uint32_t end) {
  if (build.mark().symbol == comprehension_mark) return build.close_counted(Kind::comprehension, end, 1);
  build.close_children(Kind::list, end);
}

void ParseState::close_record(std::uint32_t end) {
  folder_.close_block();
  Ast& ast = build.ast();
  bool is_list = true, is_told = false;
  for (std::uint32_t i = 0; i < build.parts(); ++i) is_list &= ast[build.part(i).node].kind != Kind::property;
  for (std::uint32_t i = 0; i < build.parts(); ++i) {
    Node& node = ast[build.part(i).node];
    if (node.kind == Kind::property || node.kind == Kind::error) continue;
    const auto complain_of = [&](Span item) {
      if (is_list && is_told) return;
      is_told = true;
      report(errors::item_in_record(item, "a record holds properties only",
                                    is_list ? "a list is written in `[ ]`" : "write `name: value`"));
    };
    if (node.kind == Kind::repeat) {
      const Repeat& repeat = ast.repeats[node.a];
      for (std::uint32_t item = 0; item < repeat.count; ++item) complain_of(ast.item_span(repeat, item));
    } else {
      complain_of(span(node.begin, node.end));
    }
    node.kind = Kind::error;
    node.a = static_cast<std::uint32_t>(no_symbol);
  }
  build.close_children(Kind::record, end);
}

// An `if` holds its `else if` as its last part, however long the chain.
void ParseState::close_if(std::uint32_t end) {
  for (bool is_chained = true; is_chained;) {
    is_chained = build.mark().symbol == chained_if;
    if (build.parts() == 2) build.nothing(end);
    build.close_linked_head(Kind::if_, end);
  }
}

// A claim without `~`, `hits` or `misses` is marked by the absence of a name.
void ParseState::close_expect(std::uint32_t end) {
  const Symbol mark = build.mark().symbol;
  const Claim claim = mark == no_symbol ? Claim::holds : static_cast<Claim>(mark);
  const auto misplaced = [&](std::uint32_t part, const char* words, const char* owners) {
    if (build.part(part).node == no_node) return;
    report(errors::malformed_expect(span(build.part(part).begin, build.part(part).end),
                                    std::string("`") + words + "` belongs to " + owners));
  };
  if (claim != Claim::hits) misplaced(2, "at t", "an expectation with `hits`");
  if (claim != Claim::hits && claim != Claim::near) misplaced(3, "within", "an expectation with `~`, or with `at t`");
  if (claim == Claim::hits && build.part(2).node == no_node)
    misplaced(3, "within", "an expectation with `~`, or with `at t`");
  build.close_expect(claim, end);
}

void ParseState::close_param(std::uint32_t end) {
  if (build.parts() == 2) build.nothing(end);
  build.close_linked_head(Kind::param, end);
}

// The end of the file with open brackets. The grammar knows which are open, the indentation shows which are unclosed.
void ParseState::fail_at_end() {
  const auto end = static_cast<std::uint32_t>(text.size());
  if (!is_at_end_) {
    is_at_end_ = true;
    std::vector<OpenBracket> forgotten = forgotten_braces(text, open_.size());
    if (forgotten.empty()) forgotten = open_;
    for (const OpenBracket& bracket : forgotten) report(unclosed_bracket(file, bracket));
  }
  throw SyntaxError{end};
}

bool ParseState::begins_with_bare_value() const {
  if (item_ == text.size() || std::string_view("-+.0123456789xyz").find(text[item_]) == std::string_view::npos)
    return false;
  if (item_follows_line_ || open_.empty() || open_.back().bracket != '{') return false;
  Token value = next_token(text, item_);
  if (value.kind == TokenKind::symbol) value = next_token(text, value.end);
  const std::string_view word = text_of(text, value);
  const bool is_short = value.kind == TokenKind::number || word == "x" || word == "y" || word == "z";
  const std::uint32_t brace = open_.back().at;
  Token first = next_token(text, brace + 1);
  while (first.kind == TokenKind::newline) first = next_token(text, first.end);
  return is_short && text_of(text, next_token(text, value.end)) == "," && first.begin == item_ &&
         is_povray_thing(text, brace);
}

ParseState::Checkpoint ParseState::begin_item(std::uint32_t at) {
  const Checkpoint checkpoint{
      build.snapshot(),  open_.size(), {newline_is_space_, block_may_follow_}, depth_, folder_.depth(), item_,
      item_follows_line_};
  item_ = at;
  item_follows_line_ = follows_line_;
  return checkpoint;
}

void ParseState::finish_item(const Checkpoint& checkpoint) {
  leave_item(checkpoint);
  if (!options.folds_repeats) return;
  // What was reported must be reported again.
  folder_.finish_item(checkpoint.build, diagnostics.empty() ? std::optional(text) : std::nullopt);
}

void ParseState::leave_item(const Checkpoint& checkpoint) {
  item_ = checkpoint.item;
  item_follows_line_ = checkpoint.follows_line;
}

std::uint32_t ParseState::replace_item(const Checkpoint& checkpoint, std::uint32_t begin, const SyntaxError& error) {
  std::string open;
  for (std::size_t i = checkpoint.open; i < open_.size(); ++i) open += open_[i].bracket;
  const std::uint32_t end = skip_broken_item(text, error.at, open, checkpoint.open > 0);
  build.restore(checkpoint.build);
  open_.resize(checkpoint.open, OpenBracket{});
  newline_is_space_ = checkpoint.modes.newline_is_space;
  block_may_follow_ = checkpoint.modes.block_may_follow;
  depth_ = checkpoint.depth;
  leave_item(checkpoint);
  folder_.restore(checkpoint.blocks);
  const std::string_view name = declared_name(text, begin);
  const Symbol symbol = name.empty() ? no_symbol : symbols.intern(name);
  build.leaf(Kind::error, begin, end, static_cast<std::uint32_t>(symbol));
  return end;
}

} // namespace rt::lang
