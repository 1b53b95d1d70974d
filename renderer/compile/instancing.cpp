#include "renderer/compile/instancing.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace rt {
namespace {

// Copies of a group are faster than instances, as long as they are few and small.
constexpr std::uint64_t least_leaves = 17;
constexpr std::uint64_t least_total = 4096;

// Counts can be astronomical, as for nested groups; half of the largest number is as good as
// infinite.
constexpr std::uint64_t many = std::numeric_limits<std::uint32_t>::max();

bool is_group(const scene::Object& object) {
  return object.shape.kind == scene::kind_of<scene::Group>;
}

} // namespace

Instancing::Instancing(const scene::Scene& scene, const std::vector<std::span<const scene::Object>>& objects) {
  const std::size_t groups = scene.shapes.all<scene::Group>().size();
  leaves_.resize(groups);
  copies_.resize(groups);
  is_instanced_.resize(groups);
  is_found_.resize(groups);
  combination_copies_.resize(scene.shapes.all<scene::Combination>().size());
  for (const auto range : objects) find_groups(scene, range);
  count_leaves(scene);
  count_copies(scene, objects);
}

void Instancing::find_groups(const scene::Scene& scene, std::span<const scene::Object> objects) {
  struct Visit {
    std::span<const scene::Object> objects;
    std::uint32_t group; // the one that has the members
    std::size_t next = 0;
  };
  const auto& groups = scene.shapes.all<scene::Group>();
  std::vector<Visit> path{{objects, 0}};
  while (!path.empty()) {
    Visit& visit = path.back();
    if (visit.next == visit.objects.size()) {
      if (path.size() > 1) innermost_first_.push_back(visit.group);
      path.pop_back();
      continue;
    }
    const scene::Object& object = visit.objects[visit.next++];
    if (!object.is_visible || !is_group(object) || is_found_[object.shape.index]) continue;
    is_found_[object.shape.index] = true;
    path.push_back({groups[object.shape.index].members, object.shape.index});
  }
}

void Instancing::count_leaves(const scene::Scene& scene) {
  for (const std::uint32_t group : innermost_first_) {
    std::uint64_t sum = 0;
    for (const scene::Object& member : scene.shapes.all<scene::Group>()[group].members) {
      if (member.is_visible) sum = std::min(many, sum + (is_group(member) ? leaves_[member.shape.index] : 1));
    }
    leaves_[group] = sum;
  }
}

// From the outside in, so that all placements of a group are known when it is decided on.
void Instancing::count_copies(const scene::Scene& scene, const std::vector<std::span<const scene::Object>>& objects) {
  const auto count = [&](std::span<const scene::Object> placed, std::uint64_t times) {
    for (const scene::Object& object : placed) {
      if (!object.is_visible) continue;
      std::uint64_t* copies = nullptr;
      if (is_group(object)) copies = &copies_[object.shape.index];
      if (object.shape.kind == scene::kind_of<scene::Combination>) copies = &combination_copies_[object.shape.index];
      if (copies) *copies = std::min(many, *copies + times);
    }
  };
  for (const auto range : objects) count(range, 1);
  for (auto it = innermost_first_.rbegin(); it != innermost_first_.rend(); ++it) {
    const std::uint64_t copies = copies_[*it], leaves = leaves_[*it];
    is_instanced_[*it] = copies > 1 && leaves >= least_leaves && copies * leaves >= least_total;
    count(scene.shapes.all<scene::Group>()[*it].members, is_instanced_[*it] ? 1 : copies);
  }
}

std::vector<std::uint32_t> Instancing::instanced() const {
  std::vector<std::uint32_t> result;
  std::copy_if(innermost_first_.begin(), innermost_first_.end(), std::back_inserter(result),
               [&](std::uint32_t group) { return is_instanced_[group]; });
  return result;
}

} // namespace rt
