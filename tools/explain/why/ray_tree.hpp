#pragma once

#include "renderer/integrators/recorder.hpp"
#include "renderer/render/ray_query.hpp"

#include <memory>
#include <optional>
#include <vector>

/// A ray and its descendants, as reported by the integrator: the numbers of this tree are the picture's own.
namespace rt::tools::explain {

struct RayNode;

/// A surface between a point and a light.
struct InTheWay {
  std::vector<std::uint32_t> path; ///< `HitReport::path`
  double distance = 0;             ///< from the point
  Color transmittance;             ///< black: it is opaque
};

/// A light as one point sees it.
struct LightNode {
  LightRecord record;
  std::vector<InTheWay> in_the_way; ///< from the point on, up to the first opaque one; the filter is their product
};

/// A branch that is not followed, since `min_weight` says so.
struct LeftOut {
  double weight;  ///< of the ray in the camera's
  Color estimate; ///< what takes the place of its radiance
};

/// The mirrored branch of a surface.
struct MirrorNode {
  Color rho;
  double reflectance = 1; ///< Fresnel's, or 1 where it is not asked for
  double cosine = 0;      ///< of the ray's angle with the normal
  double eta = 1;         ///< ior of the other side by that of this one, where Fresnel's is asked for
  std::optional<LeftOut> left_out;
  std::unique_ptr<RayNode> ray; ///< none where ρ is black, or it is left out
};

/// The refracted branch.
struct TransitionNode {
  Color tau;
  MediumTransition transition;
  double cosine = 0, cosine_behind = 0; ///< of the angles with the normal, before and behind the surface
  std::optional<LeftOut> left_out;
  std::unique_ptr<RayNode> ray; ///< none where τ is black, or the ray goes on unbent: then the next surface is its own
};

/// What replaces both on total internal reflection.
struct TotalReflectionNode {
  MediumTransition transition; ///< that did not take place
  double cosine = 0;
  std::unique_ptr<RayNode> ray;
};

/// The transmittance of a medium up to the surface that was hit.
struct AbsorptionNode {
  Color left = white;
  double length = 0;
};

/// One surface that a ray hit.
struct SurfaceNode {
  Ray ray; ///< as it arrived: the node's own, or the one that continues unbent behind the surface before; at touching
           ///< surfaces, the one that hit them
  RayHit hit;
  std::vector<std::vector<std::uint32_t>> touching; ///< paths of all surfaces in this place, given at the first of them
  std::vector<std::uint32_t> path;
  Surface surface;
  MaterialValues material;
  Vec3 normal;  ///< the shading normal, facing the viewer
  Color passed; ///< the transmittance of the surfaces crossed unbent before it, and of media on the way
  std::optional<AbsorptionNode> absorbed; ///< on the last part of the way, if it was in an absorbing medium
  Color ambient, emission;
  std::vector<LightNode> lights;
  std::optional<MirrorNode> mirror;
  std::optional<TransitionNode> transition;
  std::optional<TotalReflectionNode> total_reflection;

  /// Its emission and ambient light, and the lights'.
  Color shading() const;
};

struct RayNode {
  /// How it ends after its last surface.
  enum class End : std::uint8_t {
    surface,    ///< at it
    background, ///< in it: nothing is hit
    too_deep    ///< it would be deeper than the scene's max_depth
  };

  RayKind kind = RayKind::camera;
  Ray ray; ///< unit direction
  int depth = 0;
  Color weight; ///< the factor of its radiance in the first ray's
  std::vector<SurfaceNode> surfaces;
  End end = End::surface;
  Color background; ///< attenuated by the medium that the ray ends in
  Color radiance;
  bool is_expanded = true; ///< false: there were too many rays, and only the radiance is known
};

/// Traces the ray with the picture's integrator and records it. Rays beyond `most_surfaces` surfaces are not expanded.
std::unique_ptr<RayNode> record(const RayQuery& query, const Ray& ray, std::size_t most_surfaces = 20'000);

} // namespace rt::tools::explain
