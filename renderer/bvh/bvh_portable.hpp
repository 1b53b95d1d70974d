#pragma once

#include "renderer/bvh/bvh.hpp"

namespace rt::bvh {

/// A binary tree in double precision, built with the binned surface area heuristic (Wald, On fast Construction of
/// SAH-based Bounding Volume Hierarchies, 2007). The same leaves give the same tree.
class PortableTree {
public:
  explicit PortableTree(const Box3& bounds);

  void build(std::vector<LeafSet> sets);

  void nearest(Query& query) const;
  bool blocks(Query& query) const;

private:
  struct LeafRef {
    std::uint32_t set, index;
  };
  struct Node {
    Box3 box;
    std::uint32_t first = 0; // its first leaf, or the first of its two children
    std::uint32_t count = 0; // number of its leaves; 0: an interior node
  };
  struct BuildRef; // a leaf while the tree is being built
  struct Task;     // a node to be split

  template <class Show>
  bool traverse(Query& query, Show&& show) const;
  static std::size_t split(std::span<BuildRef> refs, bool by_area);

  std::vector<LeafSet> sets_;
  std::vector<LeafRef> leaves_;
  std::vector<Node> nodes_; // the first is the root
  double padding_;
};

} // namespace rt::bvh
