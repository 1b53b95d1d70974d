#pragma once

#include "lang/check/expressions.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace rt::lang {

/// Checks the items of a block: declarations, loops, properties, things.
class ItemChecker {
public:
  ItemChecker(CheckContext& context, Scopes& scopes, NameResolver& names)
      : context_(context), scopes_(scopes), names_(names), expressions_(context, scopes, names, *this) {}

  /// All items of a block, in the current scope.
  void check_all(Unit& unit, NodeId block);
  /// Declares what is visible before its line: defs and fns, including those of an included file.
  void hoist(Unit& unit, NodeId item);
  void check(Unit& unit, NodeId item);
  /// A block that describes its owner.
  void check_block(Unit& unit, NodeId block, const Owner& owner);
  /// A block of bindings, then one expression. `what` describes the block: "a function".
  void check_value_block(Unit& unit, NodeId block, std::string_view what);
  StaticType check_value(Unit& unit, NodeId node) { return expressions_.check(unit, node); }
  /// The parameters and the body of a function.
  void check_function(Unit& unit, FunctionInfo& info);

private:
  void hoist_function(Unit& unit, NodeId item);
  void hoist_include(Unit& unit, NodeId item);
  void check_repeat(Unit& unit, const Repeat& repeat);
  void check_property_value(Unit& unit, NodeId item);
  void check_use(Unit& unit, NodeId item);
  void check_param(Unit& unit, NodeId item);
  void check_bind(Unit& unit, NodeId item);
  void check_for(Unit& unit, NodeId item);
  void check_if(Unit& unit, NodeId item);
  void check_expect(Unit& unit, NodeId item);
  void declare_error(Unit& unit, NodeId item);
  void declare_parameters(Unit& unit, FunctionInfo& info);
  DeclarationId declare(const Unit& unit, NodeId name, NodeId item, Declaration::What what);

  CheckContext& context_;
  Scopes& scopes_;
  NameResolver& names_;
  ExpressionChecker expressions_;
  std::vector<std::pair<const Unit*, NodeId>> wrong_models_; // of repeats
};

} // namespace rt::lang
