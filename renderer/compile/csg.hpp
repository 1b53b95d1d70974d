#pragma once

#include "renderer/bvh/bvh.hpp"
#include "renderer/compile/geometries.hpp"
#include "renderer/compile/trace_query.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace rt {

/// Collects the boxes that a whole line crosses.
struct LineQuery : bvh::Query {
  LineQuery(const Ray& r, std::vector<std::uint32_t>& f)
      : Query(r, {-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}), found(f) {}
  std::vector<std::uint32_t>& found;
};

/// A combination of solids, made ready for tracing. Along a line each operand is a list of intervals, and so is what
/// the operations make of them (Roth, Ray Casting for Modeling Solids, 1982); the ends of the intervals are the
/// surface. Where operands' surfaces touch, as far as rounding can tell, the line crosses them all at once, and the one
/// declared first is taken: no skin is left over a hole that is cut flush with the surface.
class CsgSolid {
public:
  using Operation = scene::Combination::Operation;

  /// A solid of the combination, with its surface.
  struct Operand {
    SolidShape shape;
    BindingId binding = inherited_binding; ///< evaluated in the combination's space
    bool casts_shadow = true;
    std::uint32_t source = 0; ///< where it was written: see `path`
  };

  /// The bounding box of the whole, transformed by `map`; possibly empty or infinite.
  Box3 box(const Affine& map = {}) const { return box_of(0, map); }

  /// Pushes the boundaries along the whole line on `scratch.boundaries`: from near to far, entering and leaving by
  /// turns.
  void push_boundaries(const Ray& ray, TraceScratch& scratch) const { push_node(0, {ray, slack(ray)}, scratch); }

  bool contains(const Vec3& p) const { return node_contains(0, p); }

  /// In the combination's space; the normal points out of the combination.
  SurfacePoint point(const Ray& ray, const RayHit& hit) const;

  const Operand& operand(std::uint32_t i) const { return operands_[i]; }
  std::uint32_t operand_count() const { return static_cast<std::uint32_t>(operands_.size()); }
  /// The indices that lead from the combination to an operand: into its list, then its members', and so on.
  std::vector<std::uint32_t> path(std::uint32_t operand) const;

  /// The material of the interior, if the combination itself has none with an index of refraction: that of its leftmost
  /// part that has one; else the default material. A nested combination's own material has priority over its parts'.
  BindingId medium(const MaterialBindings& bindings, BindingId inherited) const;
  /// Whether any of its surfaces transmits light.
  bool is_medium(const MaterialBindings& bindings, BindingId inherited) const;

private:
  friend class CsgBuilder;

  // A node's children are operands or other nodes.
  struct Child {
    std::uint32_t index;
    bool is_node;
  };
  struct ChildBoxes {
    std::vector<Box3> boxes;
    std::vector<std::uint32_t> children; // by index in the node

    std::uint32_t size() const { return static_cast<std::uint32_t>(boxes.size()); }
    Box3 bounds(std::uint32_t i) const { return boxes[i]; }
    void nearest(std::uint32_t, LineQuery&) const {}
    bool blocks(std::uint32_t i, LineQuery& query) const {
      query.found.push_back(children[i]);
      return false;
    }
  };
  // Finds the children that a line may cross, where there are many.
  struct Index {
    ChildBoxes boxes;
    std::vector<std::uint32_t> others; // those without a finite box
    bvh::Tree tree;
  };
  struct Node {
    Operation operation = Operation::unite;
    std::vector<Child> children;
    std::unique_ptr<Index> index; // of all children that may be skipped: those of a union, and subtracted ones
  };
  // A line, and how near to each other boundaries must be to be looked at closely.
  struct Line {
    const Ray& ray;
    Slack slack;
  };
  // The parent's entry and the position in its list.
  struct Source {
    std::uint32_t parent;
    std::uint32_t position;
  };

  Box3 box_of(std::uint32_t node, const Affine& map) const;
  Box3 box_of(const Child& child, const Affine& map) const;
  Slack slack(const Ray& ray) const;
  void push_node(std::uint32_t node, const Line& line, TraceScratch& scratch) const;
  void push_child(const Node& node, std::uint32_t i, const Line& line, TraceScratch& scratch) const;
  void sweep(const Line& line, std::vector<Boundary>& list, std::size_t begin, std::size_t depth,
             std::size_t threshold) const;
  std::size_t end_of_place(const Line& line, const std::vector<Boundary>& list, std::size_t first) const;
  SurfacePoint operand_point(std::uint32_t operand, const Ray& ray, const Hit& hit) const;
  bool node_contains(std::uint32_t node, const Vec3& p) const;
  bool child_contains(const Child& child, const Vec3& p) const;

  std::vector<Operand> operands_;
  std::vector<Node> nodes_; // the first is the root
  std::vector<Source> sources_;
  std::vector<BindingId> media_; // candidates for the medium's, the first one best
  double reach_ = 0;             // no point of a finite operand has a greater magnitude
};

/// Builds the solid of a combination.
class CsgBuilder {
public:
  /// All must outlive the builder.
  CsgBuilder(const scene::Scene& scene, const bvh::Device& device, MaterialBindings& bindings, HitRules rules)
      : scene_(scene), device_(device), bindings_(bindings), rules_(rules) {}

  /// `map` leads from the combination's space to the one that the solid is placed in.
  CsgSolid build(const scene::Combination& combination, const Affine& map);

private:
  struct ListFrame;
  void visit(CsgSolid& solid, std::vector<ListFrame>& frames);
  void add_medium(CsgSolid& solid, BindingId binding) const;
  void add_operand(CsgSolid& solid, const ListFrame& frame, const scene::Object& object, std::uint32_t source);
  void add_index(CsgSolid& solid, CsgSolid::Node& node);

  const scene::Scene& scene_;
  const bvh::Device& device_;
  MaterialBindings& bindings_;
  HitRules rules_;
};

} // namespace rt
