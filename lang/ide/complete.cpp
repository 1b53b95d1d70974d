#include "lang/ide/complete.hpp"

#include "lang/builtins/builtins.hpp"
#include "lang/check/program.hpp"
#include "lang/session/session_text.hpp"
#include "lang/text/tokens.hpp"
#include "lang/text/words.hpp"
#include "lang/values/css_colors.hpp"
#include "lang/values/properties.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>

namespace rt::lang {
namespace {

constexpr std::string_view statement_words[] = {"def", "fn", "for", "if", "include", "param", "use"};
constexpr std::string_view expression_words[] = {"and", "else", "false", "fn", "if", "in", "none", "not", "or", "true"};

// A bracket that is open at the cursor. `owner` is the name before a `{` that opens the block of a thing.
struct Open {
  char bracket = '{';
  std::string_view owner;
  bool holds_statements = false;
};

// The context of the cursor, as far as the text before it shows.
struct Place {
  std::size_t begin = 0;     // of the word that is being typed
  std::string_view before;   // the token before that word; empty at the beginning of a line
  std::string_view property; // whose value is being typed
  std::vector<Open> open;
  bool is_text = false; // in a string or a comment, or in a number
  bool is_path = false; // in the string of an `include` or `use`, which begins at `begin`
};

class DocumentScanner {
public:
  explicit DocumentScanner(std::string_view text) : text_(text) {}

  Place run() {
    place_.begin = text_.size();
    std::uint32_t at = 0;
    while (true) {
      const Token token = next_token(text_, at);
      if (token.kind == TokenKind::end) break;
      at = token.end;
      if (token.end == text_.size() && ends_place(token)) break;
      take(token);
    }
    return std::move(place_);
  }

private:
  // The token that the cursor touches: a word is what is being completed; inside strings and comments there are none.
  bool ends_place(const Token& token) {
    switch (token.kind) {
    case TokenKind::name:
      place_.begin = token.begin;
      return true;
    case TokenKind::line_comment:
    case TokenKind::number:
    case TokenKind::color:
      place_.is_text = true;
      return true;
    case TokenKind::string:
      place_.is_text = token.end - token.begin < 2 || text_.back() != '"';
      place_.is_path = place_.is_text && (place_.before == "include" || place_.before == "use");
      if (place_.is_path) place_.begin = token.begin + 1;
      return place_.is_text;
    default:
      return false;
    }
  }

  void take(const Token& token) {
    const std::string_view word = text_of(text_, token);
    switch (token.kind) {
    case TokenKind::newline:
    case TokenKind::separator:
      place_.before = {};
      place_.property = {};
      first_ = {};
      return;
    case TokenKind::line_comment:
    case TokenKind::block_comment:
      return;
    case TokenKind::open:
      open(word.front());
      break;
    case TokenKind::close:
      if (!place_.open.empty()) place_.open.pop_back();
      break;
    case TokenKind::name:
      if (first_.empty()) first_ = word;
      last_name_ = word;
      break;
    case TokenKind::symbol:
      if (word == ":") place_.property = last_name_;
      break;
    default:
      break;
    }
    place_.before = word;
  }

  void open(char bracket) {
    Open opened{bracket, {}, false};
    if (bracket == '{') {
      const bool is_body = first_ == "for" || first_ == "if" || first_ == "else" || place_.before == "else";
      if (first_ == "def")
        opened = {bracket, "group", true};
      else if (is_body)
        opened = place_.open.empty() ? Open{bracket, {}, true} : Open{bracket, place_.open.back().owner, true};
      else if (place_.before == last_name_)
        opened.owner = last_name_;
    }
    place_.open.push_back(opened);
    place_.property = {};
    first_ = {};
  }

  std::string_view text_, first_, last_name_; // the first word of the statement, the last of all
  Place place_;
};

// What is known about the names that a text declares.
struct DeclaredNames {
  std::vector<std::string> all;
  std::function<const NodeType*(std::string_view)> noun_of; // of a noun or a thing, also of the language's own
  std::function<std::vector<std::string>(std::string_view)> properties_of;
};

DeclaredNames names_of(const Session& session) {
  return {session.names(), [&session](std::string_view name) { return session.noun_of(name); },
          [&session](std::string_view name) { return session.properties_of(name); }};
}

// Those of a file and of all that it includes, as far as the texts show what they are.
class ProgramNames {
public:
  ProgramNames(const Program& program, FileId file) : program_(program) {
    const Unit* whole = program.main;
    for (const ModuleInfo& module : program.modules)
      if (holds(module.unit, file)) whole = module.unit;
    add(*whole);
  }

  std::vector<std::string> all() const {
    std::vector<std::string> names;
    for (const auto& [name, value] : values_) names.emplace_back(program_.symbols.name(name));
    for (const auto& [name, item] : functions_) names.emplace_back(program_.symbols.name(name));
    return names;
  }

  const NodeType* noun_of(std::string_view name) const {
    const Symbol model = model_of(program_.symbols.find(name));
    if (const auto found = functions_.find(model); found != functions_.end())
      return found->second.ast->kind(found->second.node) == Kind::def ? program_.types.find("group") : nullptr;
    for (const Program::LibraryName& entry : program_.library_names)
      if (entry.name == model) return &program_.types.material();
    return model == no_symbol ? program_.types.find(name) : program_.types.find(program_.symbols.name(model));
  }

  std::vector<std::string> properties_of(std::string_view name) const {
    std::vector<std::string> words;
    if (const NodeType* type = noun_of(name))
      for (const Property& property : type->properties) words.emplace_back(property.name);
    if (const auto found = functions_.find(model_of(program_.symbols.find(name))); found != functions_.end()) {
      const auto& [ast, node] = found->second;
      for (const NodeId parameter : ast->function(node).parameters)
        words.emplace_back(program_.symbols.name(ast->symbol(ast->parameter(parameter).name)));
    }
    return words;
  }

private:
  struct Place {
    const Ast* ast;
    NodeId node;
  };

  static bool holds(const Unit* unit, FileId file) {
    if (!unit) return false;
    return unit->ast.file == file || std::any_of(unit->includes.begin(), unit->includes.end(),
                                                 [&](const auto& entry) { return holds(entry.second, file); });
  }

  void add(const Unit& unit) {
    const Ast& ast = unit.ast;
    for (const NodeId item : ast.children(ast.root)) {
      const Kind kind = ast.kind(item);
      if (kind == Kind::bind) values_[ast.symbol(ast.bind_item(item).name)] = {&ast, ast.bind_item(item).value};
      if (kind == Kind::param) values_[ast.symbol(ast.param_item(item).name)] = {&ast, no_node};
      if (kind == Kind::use) values_[ast.symbol(ast.use_item(item).name)] = {&ast, no_node};
      if (kind == Kind::def || kind == Kind::fn) functions_[ast.symbol(ast.function(item).name)] = {&ast, item};
      if (const Unit* included = kind == Kind::include ? unit.included(item) : nullptr) add(*included);
    }
  }

  // What a bound name is ultimately a copy of; any other name is itself.
  Symbol model_of(Symbol name) const {
    for (std::size_t steps = 0; steps <= values_.size(); ++steps) { // a name may be bound to itself, by mistake
      const auto bound = values_.find(name);
      if (bound == values_.end()) return name;
      const auto& [ast, value] = bound->second;
      if (value == no_node) return no_symbol;
      const NodeId base = innermost(*ast, value);
      if (ast->kind(base) != Kind::name) return no_symbol;
      name = ast->symbol(base);
    }
    return no_symbol;
  }

  const Program& program_;
  std::map<Symbol, Place> values_;    // of bindings; no node if nothing can be seen of the value
  std::map<Symbol, Place> functions_; // defs and fns
};

// How relevant a word is to what is being typed; the most relevant are offered first.
enum class Nearness : std::uint8_t { place, thing, function };

class Candidates {
public:
  Candidates(const Program& program, const DeclaredNames& names)
      : program_(program), names_(names), nouns_(program.types) {}

  void add(std::string_view word, Nearness nearness) { words_.emplace_back(nearness, word); }
  void add_all(const std::vector<std::string>& words, Nearness nearness) {
    for (const std::string& word : words) add(word, nearness);
  }
  void add_nouns() {
    for (const NodeType& type : nouns_.all()) add(type.name, Nearness::thing);
  }
  void add_scene_properties() {
    for (const Property& property : nouns_.scene().properties) add(property.name, Nearness::place);
  }
  void add_values() {
    add_all(names_.all, Nearness::thing);
    for (const Program::LibraryName& name : program_.library_names)
      add(program_.symbols.name(name.name), Nearness::thing);
    for (const Builtin* builtin : all_builtins()) add(builtin->name, Nearness::function);
    for (const Constant& constant : constants()) add(constant.name, Nearness::function);
  }
  void add_types(Category category) {
    for (const NodeType& type : nouns_.all())
      if (type.category == category) add(type.name, Nearness::place);
  }
  void add_colors(Nearness nearness) {
    for (const CssColor& color : css_colors()) add(color.name, nearness);
  }

  void add_place(const Place& place) {
    if (place.before == ".") {
      for (const ChainMethod& method : chain_methods()) add(method.name, Nearness::place);
    } else if (place.open.empty() || (place.open.back().bracket == '{' && begins_item(place))) {
      add_item(place);
    } else {
      add_expression(place);
    }
  }

  WordCompletion beginning_with(std::string_view start, std::size_t begin) {
    std::erase_if(words_, [&](const auto& word) { return !word.second.starts_with(start); });
    std::sort(words_.begin(), words_.end());
    WordCompletion found{begin, {}};
    std::unordered_set<std::string_view> taken;
    for (const auto& [nearness, word] : words_)
      if (taken.insert(word).second) found.words.emplace_back(word);
    return found;
  }

private:
  static bool begins_item(const Place& place) { return place.before.empty() || place.before == "{"; }

  // A statement, or a property of the thing whose block it is.
  void add_item(const Place& place) {
    if (!begins_item(place)) return add_expression(place);
    const std::string_view owner = place.open.empty() ? "" : place.open.back().owner;
    if (!owner.empty())
      add_all(names_.properties_of(owner), Nearness::place);
    else if (place.open.empty())
      add_scene_properties();
    const NodeType* type = names_.noun_of(owner);
    const bool holds_things = owner.empty() || !type || type->is_composite() || place.open.back().holds_statements;
    if (!holds_things) return;
    for (const std::string_view word : statement_words) add(word, Nearness::thing);
    add_nouns();
    add_values();
  }

  const Property* find_property(const Place& place) const {
    if (place.property.empty()) return nullptr;
    const std::string_view owner = place.open.empty() ? "" : place.open.back().owner;
    const NodeType* type = place.open.empty() ? &nouns_.scene() : names_.noun_of(owner);
    if (!type) return nullptr;
    const auto id = type->find(place.property);
    return id ? &type->properties[*id] : nullptr;
  }

  void add_expression(const Place& place) {
    add_values();
    const Property* property = find_property(place);
    if (!property) {
      add_nouns();
      add_colors(Nearness::thing);
      for (const std::string_view word : expression_words) add(word, Nearness::function);
      return;
    }
    add("if", Nearness::function);
    if (property->is_textured()) add_types(Category::pattern);
    if (takes_function(*property)) add("fn", Nearness::function);
    switch (property->type) {
    case PropertyType::boolean:
      add("true", Nearness::place);
      add("false", Nearness::place);
      break;
    case PropertyType::choice:
      for (const std::string_view choice : property->choices) add(choice, Nearness::place);
      break;
    case PropertyType::material:
      add_types(Category::material);
      add_types(Category::pattern);
      add_colors(Nearness::place);
      break;
    case PropertyType::metal:
      add_types(Category::material);
      break;
    case PropertyType::stops:
      add_types(Category::pattern);
      add_colors(Nearness::place);
      break;
    case PropertyType::color:
      add_colors(Nearness::place);
      break;
    default:
      break;
    }
  }

  const Program& program_;
  const DeclaredNames& names_;
  const NodeTypes& nouns_;
  std::vector<std::pair<Nearness, std::string>> words_;
};

WordCompletion complete_in(std::string_view text, std::size_t cursor, const Program& program,
                           const DeclaredNames& names) {
  const std::string_view before = text.substr(0, cursor);
  const Place place = DocumentScanner(before).run();
  if (place.is_path) return {place.begin, {}, true};
  if (place.is_text) return {cursor, {}};
  Candidates candidates(program, names);
  candidates.add_place(place);
  return candidates.beginning_with(before.substr(place.begin), place.begin);
}

} // namespace

WordCompletion complete(const Session& session, std::string_view text, std::size_t cursor) {
  return complete_in(text, cursor, session.program(), names_of(session));
}

WordCompletion complete(const Analysis& analysis, FileId file, std::uint32_t place) {
  const Program& program = *analysis.program;
  const ProgramNames names(program, file);
  const DeclaredNames declared{names.all(), [&names](std::string_view name) { return names.noun_of(name); },
                               [&names](std::string_view name) { return names.properties_of(name); }};
  return complete_in(program.sources.file(file).text, place, program, declared);
}

std::vector<std::string> documented_words(const Session& session) {
  std::vector<std::string> words;
  const NodeTypes& types = session.program().types;
  for (const NodeType& type : types.all()) {
    words.emplace_back(type.name);
    for (const Property& property : type.properties) words.emplace_back(property.name);
  }
  for (const Builtin* builtin : all_builtins()) words.emplace_back(builtin->name);
  for (const Constant& constant : constants()) words.emplace_back(constant.name);
  for (const ChainMethod& method : chain_methods()) words.emplace_back(method.name);
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

} // namespace rt::lang
