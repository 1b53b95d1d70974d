#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/lighting/emitter.hpp"
#include "renderer/lighting/light_tree.hpp"

#include <optional>
#include <unordered_map>
#include <vector>

namespace rt {

/// The lamps among the shapes of a scene: all whose material emits light, whose surface can be sampled, and which block
/// light. One that blocks none is visible but lights nothing.
class Emitters {
public:
  explicit Emitters(const CompiledScene& scene);

  bool is_empty() const { return list_.empty(); }
  const Emitter& operator[](std::uint32_t index) const { return list_[index].emitter; }

  /// The one that was hit, if any.
  std::optional<std::uint32_t> find(const RayHit& hit) const;

  using Choice = LightTree::Choice;
  /// Chooses one for a point, by how much light it may send there, for a uniform `u`. There must be one.
  Choice choose(const Vec3& p, double u) const { return tree_.choose(p, u); }
  /// The probability that it is chosen for p.
  double probability(std::uint32_t index, const Vec3& p) const { return tree_.probability(index, p); }

private:
  // What a hit on it contains.
  struct Identity {
    const void* leaves;
    std::uint64_t base;
    std::uint32_t index, operand;
    friend bool operator==(const Identity&, const Identity&) = default;
  };
  struct IdentityHash {
    std::size_t operator()(const Identity& identity) const;
  };
  struct ListedEmitter {
    Emitter emitter;
    Identity identity;
    std::uint64_t order; // of its object
    double power;        // up to a factor
  };
  class Search;

  std::vector<ListedEmitter> list_;
  LightTree tree_;
  std::unordered_map<Identity, std::uint32_t, IdentityHash> by_identity_;
};

} // namespace rt
