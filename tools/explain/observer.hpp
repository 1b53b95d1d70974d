#pragma once

#include "lang/builtins/expect.hpp"

namespace rt::tools::explain {

/// Who looks at a scene for the expectations in it: the tracer that makes the pictures.
lang::ObserverMaker tracing_observer();

} // namespace rt::tools::explain
