#pragma once

#include "lang/builtins/expect.hpp"

namespace rt::tools::explain {

/// Observes a scene for the expectations in it, with the tracer that makes the pictures.
lang::ObserverMaker tracing_observer();

} // namespace rt::tools::explain
