#pragma once

#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// How often the groups and combinations of a scene are placed, and which groups deserve an aggregate. What is inside
/// a combination is not counted: that is up to the combination. `objects` are the ranges of the scene's list to
/// consider.
class Instancing {
public:
  Instancing(const scene::Scene& scene, const std::vector<std::span<const scene::Object>>& objects);

  bool is_instanced(std::uint32_t group) const { return is_instanced_[group]; }
  bool is_shared(const scene::ShapeRef& combination) const { return combination_copies_[combination.index] > 1; }
  /// The groups that become aggregates, each after those it has instances of.
  std::vector<std::uint32_t> instanced() const;

private:
  void find_groups(const scene::Scene& scene, std::span<const scene::Object> objects);
  void count_leaves(const scene::Scene& scene);
  void count_copies(const scene::Scene& scene, const std::vector<std::span<const scene::Object>>& objects);

  std::vector<bool> is_found_;
  std::vector<std::uint32_t> innermost_first_;
  std::vector<std::uint64_t> leaves_; // by group: of all levels
  std::vector<std::uint64_t> copies_; // by group: how often its members would occur in the aggregates
  std::vector<std::uint64_t> combination_copies_;
  std::vector<bool> is_instanced_;
};

} // namespace rt
