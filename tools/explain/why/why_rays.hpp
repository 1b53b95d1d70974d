#pragma once

#include "tools/explain/why/why.hpp"

/// Rays and the surfaces that they met, as text.
namespace rt::tools::explain {

/// The tree of rays, each set in below the surface from which it goes on.
void write_tree(const Answer& answer, const Detail& detail, Page& page);

/// The rays on the path that carries most of the light, one after the other; the first surface with its derivation, the
/// last with its shading. What other rays bring is in the sums.
void write_path(const Answer& answer, Page& page);

} // namespace rt::tools::explain
