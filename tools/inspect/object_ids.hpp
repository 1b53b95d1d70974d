#pragma once

#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tools {

/// What the ids of a film (`Film::object_id`) stand for: from 1, one for each visible shape or combination in the order
/// of declaration, those in groups counted wherever they stand.
class ObjectIds {
public:
  /// The scene must outlive it.
  explicit ObjectIds(const scene::Scene& scene);

  struct Range {
    std::uint64_t first, last; ///< none where last < first
  };
  /// The ids of the scene's i-th object.
  Range range(std::size_t i) const { return {firsts_[i], firsts_[i + 1] - 1}; }

  struct NamedRange {
    std::string_view name;
    Range ids;
  };
  /// The ids that have a name, in their order, neighbours of one name together.
  std::vector<NamedRange> manifest() const;

  /// The name of the outermost named thing that holds it, which several may share; else its noun and the id itself.
  std::string name(std::uint64_t id) const;

private:
  std::uint64_t count(const scene::Object& object) const;
  void add_named(const scene::Object& object, std::uint64_t first, std::vector<NamedRange>& list) const;

  const scene::Scene& scene_;
  mutable std::vector<std::uint64_t> in_group_; // by group, once it was counted
  std::vector<std::uint64_t> firsts_;           // and in the end what follows the last
};

} // namespace rt::tools
