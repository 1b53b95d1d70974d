#pragma once

#include "lang/check/scopes.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rt::lang {

struct TopItem;

/// Resolves names: to bindings in scope, or to what the language itself declares.
class NameResolver {
public:
  NameResolver(CheckContext& context, Scopes& scopes) : context_(context), scopes_(scopes) {}

  /// Stores the resolution in the name's node, or reports that the name is unknown.
  StaticType resolve(Unit& unit, NodeId name, Reference::Use use = Reference::Use::reads);
  /// The same for a question, which exists only inside `expect`; nothing if the name is not one.
  std::optional<StaticType> resolve_question(Unit& unit, NodeId name);

  /// Records as references the names in a text that is in error and so was not parsed. Nothing is reported.
  void refer_to_names(Span text);

  /// The name whose right side is being read: it has no value there.
  struct BeingBound {
    Symbol name = no_symbol;
    bool is_lambda = false; ///< its right side is an anonymous function
  };
  BeingBound being_bound() const { return being_bound_; }
  void set_being_bound(BeingBound bound) { being_bound_ = bound; }
  void set_in_expect(bool is_in_expect) { is_in_expect_ = is_in_expect; }
  /// A file could not be read: names that are not found may be declared there.
  void set_names_missing() { names_are_missing_ = true; }
  /// The value of a property that takes one of these words is being read; empty if it takes other values.
  void set_choices(std::span<const std::string_view> choices) { choices_ = choices; }
  /// A value from the command line is being read.
  void set_in_define() { is_in_define_ = true; }

  /// Names read from now on are attributed to this statement of a session; null for none.
  void set_statement(TopItem* item) { statement_ = item; }
  /// Adds names known outside of what is being read, for suggestions.
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
