#include "lang/check/name_uses.hpp"

#include "lang/diagnostics/report.hpp"

#include <fmt/format.h>

namespace rt::lang {

std::uint32_t NameUses::declare(What what, Symbol symbol, Span span, bool is_exported) {
  Name& name = names_.emplace_back();
  name.what = what;
  name.symbol = symbol;
  name.span = span;
  name.is_exported = is_exported;
  name.reader = readers_.empty() ? none : readers_.back();
  return static_cast<std::uint32_t>(names_.size() - 1);
}

void NameUses::read(std::uint32_t name, bool part) {
  const std::uint32_t reader = readers_.empty() ? none : readers_.back();
  if (reader == name) return; // a function that calls itself is not used by that
  names_[name].is_read = true;
  names_[name].is_read_whole |= !part;
  (reader == none ? roots_ : names_[reader].reads).push_back(name);
}

void NameUses::mark(std::uint32_t first, std::vector<bool>& marked) const {
  std::vector<std::uint32_t> pending{first};
  while (!pending.empty()) {
    const std::uint32_t name = pending.back();
    pending.pop_back();
    if (marked[name]) continue;
    marked[name] = true;
    pending.insert(pending.end(), names_[name].reads.begin(), names_[name].reads.end());
  }
}

std::vector<bool> NameUses::needed() const {
  std::vector<bool> needed(names_.size());
  for (const std::uint32_t root : roots_) mark(root, needed);
  for (std::uint32_t i = 0; i < names_.size(); ++i) {
    if (names_[i].is_exported) mark(i, needed);
  }
  return needed;
}

void NameUses::tell(Report& report, const SymbolTable& symbols) const {
  const std::vector<bool> is_needed = needed();
  std::vector<bool> is_explained(names_.size()); // its silence follows from a name that was told of
  std::vector<bool> has_other_reader(names_.size());
  for (std::uint32_t i = 0; i < names_.size(); ++i) {
    if (is_needed[i]) continue;
    for (const std::uint32_t target : names_[i].reads) has_other_reader[target] = true;
  }
  const auto is_inside_unused = [&](const Name& name) { return name.reader != none && !is_needed[name.reader]; };
  const auto explain = [&](std::uint32_t i) {
    if (!is_inside_unused(names_[i])) tell_unused(names_[i], report, symbols);
    mark(i, is_explained);
  };
  for (std::uint32_t i = 0; i < names_.size(); ++i) {
    if (!is_needed[i] && !has_other_reader[i]) explain(i);
  }
  for (std::uint32_t i = 0; i < names_.size(); ++i) { // functions that call each other, and nobody else does
    if (!is_needed[i] && !is_explained[i]) explain(i);
  }
  for (std::uint32_t i = 0; i < names_.size(); ++i) {
    if (is_needed[i] && names_[i].what == What::thing && names_[i].is_read && !names_[i].is_read_whole &&
        !names_[i].is_exported)
      tell_parts_only(names_[i], report, symbols);
  }
}

void NameUses::tell_unused(const Name& name, Report& report, const SymbolTable& symbols) const {
  const std::string_view word = symbols.name(name.symbol);
  const auto tell = [&](std::string_view code, std::string message, std::string label, std::string advice) {
    Diagnostic* d = report.remark(code, name.span);
    if (!d) return;
    d->message = std::move(message);
    d->label = std::move(label);
    d->notes.push_back({std::nullopt, std::move(advice)});
  };
  const std::string unused = fmt::format("`{}` is never used", word);
  const std::string take_out = "if it is not needed, take it out";
  switch (name.what) {
  case What::thing:
    return tell("W0101", fmt::format("`{}` is bound and never placed", word), "it is not in the scene",
                fmt::format("after `=` a thing is kept for later: to place it, write `{}` on a line of its own", word));
  case What::def:
    return tell("W0102", unused, "no such thing is in the scene",
                fmt::format("to place one, write `{} {{}}` on a line of its own", word));
  case What::fn:
    return tell("W0102", unused, "nothing calls it", take_out);
  case What::param:
    return tell("W0102", unused, "setting it changes nothing",
                fmt::format("write `{}` where its value is meant", word));
  case What::module:
    return tell("W0102", unused, "nothing of this file is used", take_out);
  case What::parameter:
    if (word.starts_with('_')) return;
    return tell(
        "W0103", fmt::format("the parameter `{}` is never used", word), "whatever is passed changes nothing",
        fmt::format("write `{0}` where its value is meant; if it must be there for its place, call it `_{0}`", word));
  case What::material:
  case What::value:
    return tell("W0102", unused, "nothing reads it", take_out);
  }
}

void NameUses::tell_parts_only(const Name& name, Report& report, const SymbolTable& symbols) const {
  Diagnostic* d = report.remark("W0101", name.span);
  if (!d) return;
  const std::string_view word = symbols.name(name.symbol);
  d->message = fmt::format("`{}` is bound and never placed", word);
  d->label = "only its properties are read";
  d->notes.push_back({std::nullopt, fmt::format("to place it, write `{}` on a line of its own", word)});
}

} // namespace rt::lang
