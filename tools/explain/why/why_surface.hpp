#pragma once

#include "tools/explain/derivation/derivation.hpp"
#include "tools/explain/intervals.hpp"
#include "tools/explain/why/why.hpp"

/// One surface of a tree of rays as text.
namespace rt::tools::explain {

/// What was met, how the ray meets it, and the terms of its shading.
void write_surface(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);
/// The angles and weights of its branches, without the branches.
void write_mirror(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);
void write_passage(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);
void write_total_reflection(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);

/// How the ray meets the surface's shape, and, where that is part of one, the combination.
Derivation derivation_of(const Answer& answer, const SurfaceNode& surface);
std::optional<CombinationIntervals> intervals_of(const Answer& answer, const SurfaceNode& surface);

} // namespace rt::tools::explain
