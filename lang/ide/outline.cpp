#include "lang/ide/outline.hpp"

#include "lang/text/characters.hpp"

#include <algorithm>
#include <map>

namespace rt::lang {
namespace {

using What = OutlineEntry::What;

std::string headline(std::string_view text) {
  return std::string(text.substr(0, text.find_first_of("\r\n")));
}

What what_of(Declaration::What what) {
  switch (what) {
  case Declaration::What::def:
    return What::noun;
  case Declaration::What::fn:
    return What::function;
  case Declaration::What::param:
    return What::parameter;
  case Declaration::What::module:
    return What::module;
  default:
    return What::value;
  }
}

bool is_listed(Declaration::What what) {
  return what != Declaration::What::parameter && what != Declaration::What::local && what != Declaration::What::unknown;
}

// The word that an item begins with; nothing if it begins otherwise.
Span first_word(const SourceMap& sources, Span item) {
  const std::string_view text = sources.text(item);
  std::uint32_t length = 0;
  while (length < text.size() && is_name_part(text[length])) ++length;
  return {item.file, item.begin, item.begin + length};
}

class Lister {
public:
  Lister(const Program& program, FileId file) : program_(program), file_(file) {
    const auto declarations = program.references.declarations();
    for (std::uint32_t i = 0; i < declarations.size(); ++i) {
      const Declaration& d = declarations[i];
      if (d.span.file == file && d.unit && is_listed(d.what)) inside_[d.inside].push_back(DeclarationId{i});
    }
  }

  std::vector<OutlineEntry> run() {
    std::vector<OutlineEntry> list = declared_in(no_declaration);
    for (const Unit& unit : program_.units)
      if (unit.ast.file == file_ && unit.ast.root != no_node && unit.ast.kind(unit.ast.root) == Kind::block)
        for (const NodeId item : unit.ast.children(unit.ast.root)) add_item(unit.ast, item, list);
    std::ranges::stable_sort(list, {}, [](const OutlineEntry& entry) { return entry.whole.begin; });
    return list;
  }

private:
  std::vector<OutlineEntry> declared_in(DeclarationId outer) const {
    std::vector<OutlineEntry> list;
    const auto found = inside_.find(outer);
    if (found == inside_.end()) return list;
    for (const DeclarationId id : found->second) {
      const Declaration& d = program_.references[id];
      const Span whole = d.unit->ast.span(d.item);
      list.push_back({what_of(d.what), std::string(program_.sources.text(d.span)),
                      headline(program_.sources.text(whole)), whole, d.span, declared_in(id)});
    }
    return list;
  }

  // An item that is not a declaration.
  void add_item(const Ast& ast, NodeId item, std::vector<OutlineEntry>& list) const {
    const Kind kind = ast.kind(item);
    if (is_declaration(kind) || kind == Kind::expect) return;
    const Span whole = ast.span(item), word = first_word(program_.sources, whole);
    if (word.begin == word.end) return;
    list.push_back({kind == Kind::property ? What::property : What::thing,
                    std::string(program_.sources.text(word)),
                    headline(program_.sources.text(whole)),
                    whole,
                    word,
                    {}});
  }

  const Program& program_;
  FileId file_;
  std::map<DeclarationId, std::vector<DeclarationId>> inside_;
};

} // namespace

std::vector<OutlineEntry> outline(const Analysis& analysis, FileId file) {
  return Lister(*analysis.program, file).run();
}

} // namespace rt::lang
