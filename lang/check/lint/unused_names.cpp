#include "lang/check/lint/lint_warnings.hpp"
#include "lang/check/lint/text_lint.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rt::lang {
namespace {

/// A file that places nothing and sets nothing of the scene is meant to be used by others.
bool places_nothing(const Ast& ast) {
  return std::ranges::all_of(ast.children(ast.root), [&](NodeId item) { return is_declaration(ast.kind(item)); });
}

/// Which declarations read which.
class ReadGraph {
public:
  explicit ReadGraph(const Program& program);

  void report_unused(Report& report) const;

private:
  using Index = std::uint32_t;
  struct Name {
    bool is_watched = false;  ///< a warning is given if it is unused
    bool is_exported = false; ///< other files may read it
    bool is_read = false;
    bool is_read_whole = false; ///< not only a property of it
    std::vector<Index> reads;
  };

  const Declaration& declaration(Index i) const { return program_.references.declarations()[i]; }
  void add(const Reference& reference, Index target);
  void mark(Index first, std::vector<bool>& marked) const;
  std::vector<bool> needed() const;

  const Program& program_;
  std::vector<Name> names_;
  std::vector<Index> roots_; // what the scene itself reads
};

ReadGraph::ReadGraph(const Program& program) : program_(program) {
  const bool is_library = places_nothing(program.main->ast);
  for (const Declaration& d : program.references.declarations()) {
    Name& name = names_.emplace_back();
    name.is_watched = d.what != Declaration::What::local && d.what != Declaration::What::unknown;
    name.is_exported = d.is_at_top_level && (is_library || d.span.file != program.main->ast.file);
  }
  for (const Reference& reference : program.references.all()) {
    const bool reads = reference.use == Reference::Use::reads || reference.use == Reference::Use::reads_part;
    const DeclarationId* target = std::get_if<DeclarationId>(&reference.referent);
    if (reads && target) add(reference, static_cast<Index>(*target));
  }
}

void ReadGraph::add(const Reference& reference, Index target) {
  if (reference.inside == static_cast<DeclarationId>(target)) return; // a recursive call does not count as a use
  Name& name = names_[target];
  name.is_read = true;
  name.is_read_whole |= reference.use == Reference::Use::reads;
  if (reference.inside == no_declaration)
    roots_.push_back(target);
  else
    names_[static_cast<Index>(reference.inside)].reads.push_back(target);
}

void ReadGraph::mark(Index first, std::vector<bool>& marked) const {
  std::vector<Index> pending{first};
  while (!pending.empty()) {
    const Index name = pending.back();
    pending.pop_back();
    if (marked[name]) continue;
    marked[name] = true;
    pending.insert(pending.end(), names_[name].reads.begin(), names_[name].reads.end());
  }
}

std::vector<bool> ReadGraph::needed() const {
  std::vector<bool> needed(names_.size());
  for (const Index root : roots_) mark(root, needed);
  for (Index i = 0; i < names_.size(); ++i) {
    if (names_[i].is_exported) mark(i, needed);
  }
  return needed;
}

// A name read only by unused names is not reported: the report about those explains it.
void ReadGraph::report_unused(Report& report) const {
  const std::vector<bool> is_needed = needed();
  std::vector<bool> is_explained(names_.size());
  std::vector<bool> has_other_reader(names_.size());
  for (Index i = 0; i < names_.size(); ++i) {
    if (is_needed[i]) continue;
    for (const Index target : names_[i].reads) has_other_reader[target] = true;
  }
  const auto explain = [&](Index i) {
    const DeclarationId inside = declaration(i).inside;
    if (inside == no_declaration || is_needed[static_cast<Index>(inside)])
      warnings::unused(report, declaration(i), program_.symbols);
    mark(i, is_explained);
  };
  for (Index i = 0; i < names_.size(); ++i) {
    if (names_[i].is_watched && !is_needed[i] && !has_other_reader[i]) explain(i);
  }
  for (Index i = 0; i < names_.size(); ++i) { // functions that are called only by each other
    if (names_[i].is_watched && !is_needed[i] && !is_explained[i]) explain(i);
  }
  for (Index i = 0; i < names_.size(); ++i) {
    const Declaration& d = declaration(i);
    const bool is_thing = d.what == Declaration::What::value && d.known.is_thing() && d.known.type->is_placeable();
    if (is_thing && is_needed[i] && names_[i].is_read && !names_[i].is_read_whole && !names_[i].is_exported)
      warnings::only_parts_read(report, d, program_.symbols);
  }
}

} // namespace

void lint_unused_names(const Program& program, Report& report) {
  ReadGraph(program).report_unused(report);
}

void lint_hidden_nouns(const Program& program, Report& report) {
  for (const Declaration& d : program.references.declarations()) {
    const bool is_local = d.what == Declaration::What::parameter || d.what == Declaration::What::local ||
                          d.what == Declaration::What::unknown;
    const std::string_view word = program.symbols.name(d.symbol);
    if (!is_local && program.types.find(word)) warnings::hidden_noun(report, d.span, word);
  }
}

void lint_text(const Program& program, Report& report) {
  lint_hidden_nouns(program, report);
  lint_angles(program, report);
  if (!report.has_errors()) lint_unused_names(program, report);
}

} // namespace rt::lang
