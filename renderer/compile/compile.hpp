#pragma once

#include "renderer/bvh/bvh.hpp"
#include "renderer/compile/hit_rules.hpp"
#include "renderer/compile/material_bindings.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rt {

struct CompiledObjects;

/// A range of a scene's list of objects that is compiled separately. Parts with equal stamps are equal: they hold equal
/// objects, and what these refer to is unchanged.
struct Part {
  std::uint32_t begin = 0, end = 0;
  std::uint64_t stamp = 0;
};

/// Compiles objects, the scene's or a range of them, to trees of leaves. A group that is placed only once is flattened:
/// its transform is multiplied into its members'. A group of some size that is placed several times becomes a separate
/// aggregate with an instance for each placement. `parts` (by index among the objects, in list order, not overlapping)
/// are `ready`. Throws std::bad_alloc or std::runtime_error.
std::shared_ptr<const CompiledObjects> compile(const scene::Scene& scene, std::span<const scene::Object> objects,
                                               const bvh::Device& device, MaterialBindings& bindings,
                                               std::span<const Part> parts = {},
                                               std::vector<std::shared_ptr<const CompiledObjects>> ready = {},
                                               HitRules rules = HitRules::own);

/// What is kept from one compilation of a growing scene to the next. The scene's tables (shapes, materials, patterns,
/// transforms) may only grow while a cache is used with it, and what an earlier compilation returned must not be traced
/// once the cache is used again.
class CompileCache {
public:
  /// `threads` to build with; 0: one per core.
  explicit CompileCache(int threads) : device_(std::make_shared<bvh::Device>(threads)) {}

  struct Counts {
    std::uint64_t parts_built = 0, parts_reused = 0;
    std::uint64_t objects_built = 0, objects_reused = 0; ///< those outside of parts are built each time
  };
  /// Since the cache was created.
  const Counts& counts() const { return counts_; }

private:
  friend class CompiledScene;

  // Parts that this many compilations did not need are evicted.
  static constexpr std::uint64_t patience = 8;

  struct CachedPart {
    std::uint64_t stamp;
    std::uint64_t last_use;
    std::shared_ptr<const CompiledObjects> compiled;
  };

  std::shared_ptr<const CompiledObjects> compile(const scene::Scene& scene, std::span<const Part> parts);
  bool knows(const Part& part) const;
  void begin(const scene::Scene& scene);
  std::shared_ptr<const CompiledObjects> take(const scene::Scene& scene, const Part& part);
  void forget_unused();

  std::shared_ptr<bvh::Device> device_;
  std::shared_ptr<MaterialBindings> bindings_;
  MaterialBindings::Mark mark_{}; // the bindings of the parts, without those of the rest of the scene
  std::vector<CachedPart> parts_;
  std::uint64_t uses_ = 0;
  Counts counts_;
};

} // namespace rt
