#include "renderer/scene/compact.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace rt::scene {
namespace {

/// Which entries of a table are in use, and their new indices.
class TableUse {
public:
  explicit TableUse(std::size_t size) : new_index_(size, unused) {}
  bool mark(std::size_t i) { return std::exchange(new_index_[i], used) == unused; }

  /// Moves the used entries to the front; true if any are removed.
  template <class T>
  bool compact(std::vector<T>& table) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < table.size(); ++i) {
      if (new_index_[i] == unused) continue;
      if (count != i) table[count] = std::move(table[i]);
      new_index_[i] = count++;
    }
    const bool shrinks = count < table.size();
    table.erase(table.begin() + count, table.end());
    return shrinks;
  }
  std::uint32_t operator[](std::size_t i) const { return new_index_[i]; }

private:
  static constexpr std::uint32_t unused = 0xffffffff, used = 0xfffffffe;
  std::vector<std::uint32_t> new_index_;
};

class Compaction {
public:
  explicit Compaction(Scene& scene)
      : scene_(scene), materials_(scene.materials.size()), patterns_(scene.patterns.size()),
        transforms_(scene.transforms.size()) {
    ShapeKinds::for_each([&]<class S>() { shapes_.emplace_back(scene.shapes.all<S>().size()); });
  }

  void run() {
    pending_.push_back(&scene_.objects);
    while (!pending_.empty()) {
      const std::vector<Object>* objects = pending_.back();
      pending_.pop_back();
      for (const Object& object : *objects) mark(object);
    }
    std::size_t kind = 0;
    ShapeKinds::for_each([&]<class S>() { shapes_[kind++].compact(scene_.shapes.all<S>()); });
    materials_.compact(scene_.materials);
    patterns_.compact(scene_.patterns);
    transforms_.compact(scene_.transforms);
    renumber(scene_.objects);
    for (Group& group : scene_.shapes.all<Group>()) renumber(group.members);
    for (Combination& combination : scene_.shapes.all<Combination>()) renumber(combination.operands);
    for (Material& material : scene_.materials) renumber_patterns(material);
    for (Pattern& pattern : scene_.patterns)
      std::visit([&](auto& layout) { renumber_patterns(layout); }, pattern.layout);
  }

private:
  void mark(const Object& object) {
    if (object.transform != no_transform) transforms_.mark(static_cast<std::size_t>(object.transform));
    if (object.material != no_material) mark(object.material);
    if (!shapes_[object.shape.kind].mark(object.shape.index)) return;
    if (object.shape.kind == kind_of<Group>) pending_.push_back(&scene_.shapes.get<Group>(object.shape).members);
    if (object.shape.kind == kind_of<Combination>)
      pending_.push_back(&scene_.shapes.get<Combination>(object.shape).operands);
  }
  void mark(MaterialId id) {
    if (!materials_.mark(static_cast<std::size_t>(id))) return;
    mark_patterns(scene_.materials[static_cast<std::size_t>(id)]);
  }
  template <class T>
  void mark_patterns(const T& owner) {
    for_each_pattern(fields(&owner), &owner, [&](PatternId id) {
      if (!patterns_.mark(static_cast<std::size_t>(id))) return;
      std::visit([&](const auto& layout) { mark_patterns(layout); },
                 scene_.patterns[static_cast<std::size_t>(id)].layout);
    });
  }

  void renumber(std::vector<Object>& objects) const {
    for (Object& object : objects) {
      object.shape.index = shapes_[object.shape.kind][object.shape.index];
      if (object.transform != no_transform)
        object.transform = TransformId{transforms_[static_cast<std::size_t>(object.transform)]};
      if (object.material != no_material)
        object.material = MaterialId{materials_[static_cast<std::size_t>(object.material)]};
    }
  }
  template <class T>
  void renumber_patterns(T& owner) const {
    replace_patterns(fields(&owner), &owner,
                     [&](PatternId id) { return PatternId{patterns_[static_cast<std::size_t>(id)]}; });
  }

  Scene& scene_;
  std::vector<TableUse> shapes_; // by kind
  TableUse materials_, patterns_, transforms_;
  std::vector<const std::vector<Object>*> pending_;
};

} // namespace

void compact(Scene& scene) {
  Compaction(scene).run();
}

} // namespace rt::scene
