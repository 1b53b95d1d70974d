#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/lighting/emitter.hpp"
#include "renderer/lighting/light_tree.hpp"

#include <optional>
#include <unordered_map>
#include <vector>

namespace rt {

/// The lamps among the shapes of a scene: all whose material shines, whose points can be drawn, and which block light.
/// What blocks none is seen, but lights nothing.
class Emitters {
public:
  explicit Emitters(const CompiledScene& scene);

  bool is_empty() const { return list_.empty(); }
  const Emitter& operator[](std::uint32_t index) const { return list_[index].emitter; }

  /// Which of them was hit.
  std::optional<std::uint32_t> find(const RayHit& hit) const;

  using Choice = LightTree::Choice;
  /// Picks one for a point, by how much light it may send there, for `u` that is spread evenly. There must be one.
  Choice choose(const Vec3& p, double u) const { return tree_.choose(p, u); }
  /// How likely it is picked for p.
  double probability(std::uint32_t index, const Vec3& p) const { return tree_.probability(index, p); }

private:
  // What a hit of it carries.
  struct Identity {
    const void* leaves;
    std::uint64_t base;
    std::uint32_t index, operand;
    friend bool operator==(const Identity&, const Identity&) = default;
  };
  struct IdentityHash {
    std::size_t operator()(const Identity& identity) const;
  };
  struct Entry {
    Emitter emitter;
    Identity identity;
    std::uint64_t order; // of its object
    double power;        // up to a factor
  };
  class Search;

  std::vector<Entry> list_;
  LightTree tree_;
  std::unordered_map<Identity, std::uint32_t, IdentityHash> by_identity_;
};

} // namespace rt
