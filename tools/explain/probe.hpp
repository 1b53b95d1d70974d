#pragma once

#include "tools/explain/question.hpp"

#include <nlohmann/json_fwd.hpp>

/// What a ray hits.
namespace rt::tools::explain {

/// The hits of a ray, the nearest only or all, as text and as JSON. A miss is a valid answer.
std::string probe_text(const scene::Scene& scene, const NamedRay& ray, const std::vector<HitReport>& hits, bool all);
nlohmann::ordered_json probe_json(const scene::Scene& scene, const NamedRay& ray, const std::vector<HitReport>& hits);

/// The nearest hit, or all.
std::vector<HitReport> find_hits(const RayQuery& query, const Ray& ray, bool all);

/// A vector and a colour as written in a scene, with enough digits to identify them.
std::string text_of(const Vec3& v);
std::string text_of(const Color& c);

} // namespace rt::tools::explain
