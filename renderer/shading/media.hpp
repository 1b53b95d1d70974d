#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// The interior of a transparent solid.
struct Medium {
  std::uint64_t id = 0; ///< of the placed solid, unique to each instance
  double ior = 1;
  std::uint32_t material_id = 0;
};

/// How crossing a surface changes the stack of media that contain a ray.
struct MediumTransition {
  enum class Kind : std::uint8_t {
    entering,
    leaving,
    entering_outer, ///< together with a solid nested in it
    leaving_outer,  ///< while still inside another that was entered later
    through_sheet   ///< which has no interior
  };
  Kind kind = Kind::entering;
  double ior_from = 1, ior_to = 1;
  double eta() const { return ior_from / ior_to; }
};

/// The stacks of media that contain the rays of one ray tree, outermost first. Lists are handles into storage that
/// grows and shrinks with the tree, so that tracing does not allocate.
class MediumStacks {
public:
  struct List {
    std::uint32_t begin = 0, size = 0;
  };

  /// The storage in use; `release(mark)` frees what was allocated since.
  std::uint32_t mark() const { return static_cast<std::uint32_t>(storage_.size()); }
  void release(std::uint32_t mark) { storage_.erase(storage_.begin() + mark, storage_.end()); }

  const Medium* begin(List list) const { return storage_.data() + list.begin; }
  const Medium* end(List list) const { return begin(list) + list.size; }
  bool holds(List list, std::uint64_t id) const { return place(list, id) < list.size; }
  /// The depth of that solid in the list; the list's size if it is not in it.
  std::uint32_t place(List list, std::uint64_t id) const {
    std::uint32_t i = 0;
    while (i < list.size && storage_[list.begin + i].id != id) ++i;
    return i;
  }
  /// The innermost; none in the void.
  const Medium* top(List list) const { return list.size == 0 ? nullptr : &storage_[list.begin + list.size - 1]; }
  double top_ior(List list) const { return list.size == 0 ? 1 : storage_[list.begin + list.size - 1].ior; }

  List make(std::span<const Medium> media) {
    const List list{mark(), static_cast<std::uint32_t>(media.size())};
    if (!media.empty()) storage_.insert(storage_.end(), media.begin(), media.end());
    return list;
  }

  /// What happens at the surface of `it`: a solid that is not in the list is entered; the innermost is left; one
  /// further out, as where solids overlap, is left without bending.
  [[gnu::always_inline]] MediumTransition transition(List list, const Medium& it) const {
    const std::uint32_t i = place(list, it.id);
    if (i == list.size) return {MediumTransition::Kind::entering, top_ior(list), it.ior};
    if (i + 1 == list.size) return {MediumTransition::Kind::leaving, it.ior, top_ior({list.begin, list.size - 1})};
    return {MediumTransition::Kind::leaving_outer, top_ior(list), top_ior(list)};
  }
  /// The list behind that surface. A list that begins at `owned_from` or later is modified in place, discarding
  /// whatever was allocated after it; others are copied if need be.
  List after(List list, const Medium& it, std::uint32_t owned_from);

  /// The effect of crossing from one list to another that has `it` added or removed; `it` need not be the innermost.
  MediumTransition transition(List before, List behind, const Medium& it) const;
  /// New lists: with one more solid, inside the first `around` ones; and without one that it contains.
  List with(List list, std::uint32_t around, const Medium& it);
  List without(List list, std::uint64_t id);
  /// The list moved down to `begin`, where unneeded storage begins. What came after it is freed.
  List moved(List list, std::uint32_t begin);

  /// The ior of the other side divided by that of this side, as Fresnel's equation takes it: behind a solid in the list
  /// is the innermost one, or nothing if it is alone.
  [[gnu::always_inline]] double fresnel_eta(List list, const Medium& it) const {
    if (list.size == 0) return it.ior;
    if (!holds(list, it.id)) return it.ior / top_ior(list);
    return (list.size == 1 ? 1 : top_ior(list)) / it.ior;
  }

private:
  std::vector<Medium> storage_;
};

} // namespace rt
