#pragma once

#include "lang/check/scopes.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rt::lang {

struct TopItem;

/// Finds what a name stands for: a binding of the scopes, or what the language itself declares.
class NameResolver {
public:
  NameResolver(CheckContext& context, Scopes& scopes) : context_(context), scopes_(scopes) {}

  /// Writes into the name's node what it stands for, or reports that there is nothing of that name.
  StaticType resolve(Unit& unit, NodeId name, Reference::Use use = Reference::Use::reads);
  /// The same for a question, which is known inside `expect` only; nothing where the name is none there.
  std::optional<StaticType> resolve_question(Unit& unit, NodeId name);

  /// Keeps as references the names of a text that is in error, and so was not read. Nothing is reported.
  void refer_to_names(Span text);

  /// The name whose right side is read: it has no value there.
  struct BeingBound {
    Symbol name = no_symbol;
    bool is_lambda = false; ///< its right side is a function without a name
  };
  BeingBound being_bound() const { return being_bound_; }
  void set_being_bound(BeingBound bound) { being_bound_ = bound; }
  void set_in_expect(bool is_in_expect) { is_in_expect_ = is_in_expect; }
  /// A file could not be read: names that are not found may have stood there.
  void set_names_missing() { names_are_missing_ = true; }
  /// The value of a property is read that takes one of these words; empty where it takes others.
  void set_choices(std::span<const std::string_view> choices) { choices_ = choices; }
  /// A value of the command line is read.
  void set_in_define() { is_in_define_ = true; }

  /// From now on the names that are read are those of this statement of a session; null for none.
  void set_statement(TopItem* item) { statement_ = item; }
  /// Adds names that are known outside of what is read, for suggestions.
  using AddNames = std::function<void(std::vector<std::string_view>&)>;
  void set_further_names(const AddNames& add) { add_further_names_ = &add; }

private:
  StaticType resolve_binding(Unit& unit, NodeId node, Binding& binding, Reference::Use use);
  StaticType resolve_global(Unit& unit, NodeId node);
  void note_use(Symbol symbol, const Binding* binding);
  void report_unknown(const Unit& unit, NodeId node);
  bool report_early(const Unit& unit, NodeId node);
  bool is_form_shown(const Span& name) const;
  std::vector<std::string_view> visible_names();

  CheckContext& context_;
  Scopes& scopes_;
  BeingBound being_bound_;
  bool is_in_expect_ = false;
  bool names_are_missing_ = false;
  bool is_in_define_ = false;
  std::span<const std::string_view> choices_;
  TopItem* statement_ = nullptr;
  const AddNames* add_further_names_ = nullptr;
};

} // namespace rt::lang
