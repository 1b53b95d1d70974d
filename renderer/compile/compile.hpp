#pragma once

#include "renderer/compile/aggregate.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rt {

/// A stretch of a scene's list of objects that is compiled by itself. Parts with the same stamp are the same: they hold
/// equal objects, and what these refer to is unchanged.
struct Part {
  std::uint32_t begin = 0, end = 0;
  std::uint64_t stamp = 0;
};

class CompileCache;

/// A scene description turned into trees of leaves. Groups that stand in one place only are taken apart: their members'
/// transforms are multiplied out. A group of some size that stands in several becomes an assembly of its own, with an
/// instance for each place.
class Compiled {
public:
  /// `threads` to build with. The scene need not outlive what is compiled. Throws std::bad_alloc or std::runtime_error.
  Compiled(const scene::Scene& scene, int threads, bvh::Builder builder);
  /// The same pictures, but with a tree of its own for each part, which is only built where the cache does not have it.
  /// `parts` are in the order of the list and do not overlap.
  Compiled(const scene::Scene& scene, std::span<const Part> parts, CompileCache& cache);

  const Aggregate& root() const { return *aggregates_.back(); }
  const MaterialBindings& bindings() const { return *bindings_; }

private:
  friend class Compiler;
  friend class CompileCache;

  Compiled(std::shared_ptr<bvh::Device> device, std::shared_ptr<MaterialBindings> bindings)
      : device_(std::move(device)), bindings_(std::move(bindings)) {}

  std::shared_ptr<bvh::Device> device_; // those of a part are the whole's
  std::shared_ptr<MaterialBindings> bindings_;
  std::vector<std::shared_ptr<const Compiled>> parts_;
  std::vector<std::unique_ptr<CsgSolid>> solids_;
  std::vector<std::unique_ptr<Aggregate>> aggregates_; // every one after those it has instances of
};

/// What is kept from one compilation of a growing scene to the next. The scene's tables (shapes, materials, patterns,
/// turns) may only grow as long as a cache is used with it, and what was compiled before with a cache must not be
/// traced once it is used again.
class CompileCache {
public:
  /// `threads` to build with, 0: one for each core.
  explicit CompileCache(int threads) : device_(std::make_shared<bvh::Device>(threads)) {}

  struct Counts {
    std::uint64_t parts_built = 0, parts_reused = 0;
    std::uint64_t objects_built = 0, objects_reused = 0; ///< those outside of parts are built each time
  };
  /// Since the cache was made.
  const Counts& counts() const { return counts_; }

private:
  friend class Compiled;

  // Parts that so many compilations did not need are forgotten.
  static constexpr std::uint64_t patience = 8;

  struct CacheEntry {
    std::uint64_t stamp;
    std::uint64_t last_use;
    std::shared_ptr<const Compiled> compiled;
  };

  bool knows(const Part& part) const;
  void begin(const scene::Scene& scene);
  std::shared_ptr<const Compiled> take(const scene::Scene& scene, const Part& part);
  void forget_unused();

  std::shared_ptr<bvh::Device> device_;
  std::shared_ptr<MaterialBindings> bindings_;
  MaterialBindings::Mark mark_{}; // the styles of the parts, without those of the rest of the scene
  std::vector<CacheEntry> entries_;
  std::uint64_t uses_ = 0;
  Counts counts_;
};

} // namespace rt
