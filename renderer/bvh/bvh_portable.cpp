#include "renderer/bvh/bvh_portable.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt::bvh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::uint32_t most_in_leaf = 2;
constexpr std::size_t bin_count = 16;
// Below this depth nodes are halved, so that no tree is deeper than the traversal stack: 2³² leaves add 32 levels.
constexpr std::uint32_t deepest_by_area = 64;
constexpr std::size_t stack_size = deepest_by_area + 34;

// How far a leaf's own arithmetic may exceed its box, relative to the size of the whole tree. A ray that comes from 2²⁴
// times as far is off by about as much.
constexpr double relative_padding = 0x1p-24;
// And how far a box's t may be off, relative to itself: a few roundings.
constexpr double slack = 0x1p-48;

double half_area(const Box3& box) {
  const Vec3 e = box.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

std::size_t longest_axis(const Vec3& v) {
  return v.x >= v.y && v.x >= v.z ? 0 : v.y >= v.z ? 1 : 2;
}

// The ray, prepared for box tests.
class SlabTest {
public:
  explicit SlabTest(const Ray& ray)
      : origin_(ray.origin), inverse_{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z} {
    for (std::size_t axis = 0; axis < 3; ++axis) is_negative_[axis] = std::signbit(inverse_[axis]);
  }

  /// Whether the ray hits the box within the interval, and where it enters, both conservatively.
  bool meets(const Box3& box, const Interval& range, double& enter) const {
    double from = range.lower, to = range.upper;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double lower = (box.lower[axis] - origin_[axis]) * inverse_[axis];
      const double upper = (box.upper[axis] - origin_[axis]) * inverse_[axis];
      // A ray within a slab's plane gives 0 · ∞, which is NaN: these comparisons ignore it.
      from = std::max(from, is_negative_[axis] ? upper : lower);
      to = std::min(to, is_negative_[axis] ? lower : upper);
    }
    enter = from - std::abs(from) * slack;
    return enter <= to + std::abs(to) * slack;
  }

private:
  Vec3 origin_, inverse_;
  std::array<bool, 3> is_negative_;
};

} // namespace

struct PortableTree::BuildRef {
  Box3 box;
  Vec3 center;
  LeafRef leaf;
};

struct PortableTree::Task {
  std::uint32_t node;
  std::size_t begin, end;
  std::uint32_t depth;
};

PortableTree::PortableTree(const Box3& bounds)
    : padding_(relative_padding * max_component(bounds.extent()) + slack * max_component(abs(bounds.center()))) {}

void PortableTree::build(std::vector<LeafSet> sets) {
  sets_ = std::move(sets);
  const Vec3 pad{padding_, padding_, padding_};
  std::vector<BuildRef> refs;
  for (std::uint32_t set = 0; set < sets_.size(); ++set)
    for (std::uint32_t i = 0; i < sets_[set].size; ++i) {
      const Box3 box = sets_[set].bounds(sets_[set].leaves, i);
      refs.push_back({{box.lower - pad, box.upper + pad}, box.center(), {set, i}});
    }

  nodes_.emplace_back();
  std::vector<Task> tasks{{0, 0, refs.size(), 0}};
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    const std::span all = std::span(refs).subspan(task.begin, task.end - task.begin);
    Box3 box;
    for (const BuildRef& ref : all) box.extend(ref.box);
    Node& node = nodes_[task.node];
    node.box = box;
    if (all.size() <= most_in_leaf) {
      node.first = static_cast<std::uint32_t>(leaves_.size());
      node.count = static_cast<std::uint32_t>(all.size());
      for (const BuildRef& ref : all) leaves_.push_back(ref.leaf);
      continue;
    }
    const std::size_t middle = task.begin + split(all, task.depth < deepest_by_area);
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    node.first = children;
    nodes_.resize(nodes_.size() + 2);
    tasks.push_back({children, task.begin, middle, task.depth + 1});
    tasks.push_back({children + 1, middle, task.end, task.depth + 1});
  }
}

// Partitions the leaves in two and returns the size of the first part.
std::size_t PortableTree::split(std::span<BuildRef> refs, bool by_area) {
  Box3 centers;
  for (const BuildRef& ref : refs) centers.extend(ref.center);
  const std::size_t axis = longest_axis(centers.extent());
  const double lower = centers.lower[axis], scale = bin_count / centers.extent()[axis];
  const auto bin_of = [&](const BuildRef& ref) {
    return std::min(bin_count - 1, static_cast<std::size_t>((ref.center[axis] - lower) * scale));
  };
  if (by_area && scale < infinity && scale > 0) {
    std::array<Box3, bin_count> boxes;
    std::array<std::size_t, bin_count> counts{};
    for (const BuildRef& ref : refs) boxes[bin_of(ref)].extend(ref.box), ++counts[bin_of(ref)];

    std::array<double, bin_count> costs{}; // of the leaves from a bin on
    Box3 box;
    std::size_t count = 0;
    for (std::size_t bin = bin_count; bin-- > 1;) {
      box.extend(boxes[bin]), count += counts[bin];
      costs[bin] = count > 0 ? half_area(box) * static_cast<double>(count) : 0;
    }
    box = {}, count = 0;
    double least = infinity;
    std::size_t cut = 0;
    for (std::size_t bin = 1; bin < bin_count; ++bin) {
      box.extend(boxes[bin - 1]), count += counts[bin - 1];
      if (count == 0 || count == refs.size()) continue;
      const double cost = half_area(box) * static_cast<double>(count) + costs[bin];
      if (cost < least) least = cost, cut = bin;
    }
    if (cut > 0) {
      const auto end = std::partition(refs.begin(), refs.end(), [&](const BuildRef& ref) { return bin_of(ref) < cut; });
      return static_cast<std::size_t>(end - refs.begin());
    }
  }
  const std::size_t half = refs.size() / 2;
  std::nth_element(refs.begin(), refs.begin() + static_cast<std::ptrdiff_t>(half), refs.end(),
                   [axis](const BuildRef& a, const BuildRef& b) { return a.center[axis] < b.center[axis]; });
  return half;
}

// Passes the leaves along the query's ray to `show`, nearer nodes first, until it returns true.
template <class Show>
bool PortableTree::traverse(Query& query, Show&& show) const {
  struct Pending {
    std::uint32_t node;
    double enter;
  };
  std::array<Pending, stack_size> stack;
  std::size_t size = 0;
  const SlabTest test(query.ray);
  double enter = 0;
  if (!test.meets(nodes_[0].box, query.interval, enter)) return false;
  stack[size++] = {0, enter};
  while (size > 0) {
    const Pending next = stack[--size];
    const double end = query.interval.upper;
    if (next.enter > end + std::abs(end) * slack) continue;
    const Node& node = nodes_[next.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (show(sets_[leaves_[i].set], leaves_[i].index)) return true;
    if (node.count > 0) continue;
    double enter_other = 0;
    const bool meets_first = test.meets(nodes_[node.first].box, query.interval, enter);
    const bool meets_other = test.meets(nodes_[node.first + 1].box, query.interval, enter_other);
    const bool is_first_nearer = enter <= enter_other;
    if (meets_other && is_first_nearer) stack[size++] = {node.first + 1, enter_other};
    if (meets_first) stack[size++] = {node.first, enter};
    if (meets_other && !is_first_nearer) stack[size++] = {node.first + 1, enter_other};
  }
  return false;
}

void PortableTree::nearest(Query& query) const {
  traverse(query, [&](const LeafSet& set, std::uint32_t i) {
    set.nearest(set.leaves, i, query);
    return false;
  });
}

bool PortableTree::blocks(Query& query) const {
  return traverse(query, [&](const LeafSet& set, std::uint32_t i) { return set.blocks(set.leaves, i, query); });
}

} // namespace rt::bvh
