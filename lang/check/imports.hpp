#pragma once

#include "lang/check/context.hpp"

namespace rt::lang {

/// The file named by an `include`, parsed; null if that fails, which is reported.
Unit* read_included(CheckContext& context, Unit& unit, NodeId item);
/// The file named by a `use`, checked (once, however often it is named); null if that fails.
const ModuleInfo* read_module(CheckContext& context, Unit& unit, NodeId item);

} // namespace rt::lang
