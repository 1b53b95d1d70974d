#pragma once

#include "lang/check/context.hpp"

namespace rt::lang {

/// The file that an `include` names, parsed; null where it cannot be had, which is reported.
Unit* read_included(CheckContext& context, Unit& unit, NodeId item);
/// The file that a `use` names, checked (once, however often it is named); null where it cannot be had.
const ModuleInfo* read_module(CheckContext& context, Unit& unit, NodeId item);

} // namespace rt::lang
