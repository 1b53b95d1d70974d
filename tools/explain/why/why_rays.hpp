#pragma once

#include "tools/explain/why/why.hpp"

/// Rays and the surfaces that they hit, as text.
namespace rt::tools::explain {

/// The ray tree, each ray indented below the surface it leaves.
void write_tree(const Answer& answer, const Detail& detail, Page& page);

/// The rays on the path that carries most of the light, in order; the first surface with its derivation, the last with
/// its shading. What other rays contribute is in the sums.
void write_path(const Answer& answer, Page& page);

} // namespace rt::tools::explain
