#pragma once

#include "tools/explain/derivation/derivation.hpp"
#include "tools/explain/intervals.hpp"
#include "tools/explain/why/why.hpp"

/// One surface of a ray tree as text.
namespace rt::tools::explain {

/// What was hit, and where.
void write_meeting(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);
/// How the ray hits the shape, and the combination that it is part of, if any.
void write_derivation(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);
void write_normal(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);
/// The terms of its shading.
void write_shading(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);
/// The angles and weights of its branches, without the branches.
void write_mirror(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);
void write_passage(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);
void write_total_reflection(const Answer& answer, const SurfaceNode& surface, Page& page, int indent);

/// How the ray hits the surface's shape, and the combination that it is part of, if any.
Derivation derivation_of(const Answer& answer, const SurfaceNode& surface);
std::optional<CombinationIntervals> intervals_of(const Answer& answer, const SurfaceNode& surface);

} // namespace rt::tools::explain
