#pragma once

#include "lang/check/names.hpp"

namespace rt::lang {

class ItemChecker;

/// Checks expressions: what their names refer to, the arguments of their calls, overrides.
class ExpressionChecker {
public:
  ExpressionChecker(CheckContext& context, Scopes& scopes, NameResolver& names, ItemChecker& items)
      : context_(context), scopes_(scopes), names_(names), items_(items) {}

  StaticType check(Unit& unit, NodeId node);

private:
  void check_parts(Unit& unit, NodeId node);
  StaticType check_if(Unit& unit, NodeId node);
  StaticType check_lambda(Unit& unit, NodeId node);
  StaticType check_call(Unit& unit, NodeId node);
  StaticType check_callee(Unit& unit, NodeId callee);
  StaticType check_member(Unit& unit, NodeId node, bool is_called);
  StaticType check_export(Unit& unit, NodeId node, const ModuleInfo& module);
  StaticType check_override(Unit& unit, NodeId node);
  void check_comprehension(Unit& unit, NodeId node);
  StaticType check_binary(Unit& unit, NodeId node);

  CheckContext& context_;
  Scopes& scopes_;
  NameResolver& names_;
  ItemChecker& items_;
};

/// Declares the variables of a loop.
void declare_loop_names(CheckContext& context, Scopes& scopes, Unit& unit, NodeId loop);

} // namespace rt::lang
