#pragma once

#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tools {

/// What the ids of a film (`Film::object_id`) refer to: from 1, one for each visible shape or combination in the order
/// of declaration, counting those in groups once per placement.
class ObjectIds {
public:
  /// The scene must outlive it.
  explicit ObjectIds(const scene::Scene& scene);

  struct Range {
    std::uint64_t first, last; ///< none if last < first
  };
  /// The ids of the scene's i-th object.
  Range range(std::size_t i) const { return {firsts_[i], firsts_[i + 1] - 1}; }

  struct NamedRange {
    std::string_view name;
    Range ids;
  };
  /// The ids that have a name, in order, with consecutive ids of one name merged.
  std::vector<NamedRange> manifest() const;

  /// The name of the outermost named thing that contains it, which several may share; else its noun and the id itself.
  std::string name(std::uint64_t id) const;

private:
  std::uint64_t count(const scene::Object& object) const;
  void add_named(const scene::Object& object, std::uint64_t first, std::vector<NamedRange>& list) const;

  const scene::Scene& scene_;
  mutable std::vector<std::uint64_t> in_group_; // by group, once counted
  std::vector<std::uint64_t> firsts_;           // and finally the id after the last
};

} // namespace rt::tools
