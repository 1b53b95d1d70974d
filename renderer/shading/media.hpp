#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// The inside of a transparent solid.
struct Medium {
  std::uint64_t id = 0; ///< the placed solid's, different for each instance
  double ior = 1;
  std::uint32_t material_id = 0;
};

/// What passing a surface does to the list of solids that a ray is inside of.
struct MediumTransition {
  enum class Kind : std::uint8_t {
    entering,
    leaving,
    entering_outer, ///< together with a solid that lies within the one entered
    leaving_outer,  ///< while inside of another that was entered later
    through_sheet   ///< which has no inside
  };
  Kind kind = Kind::entering;
  double ior_from = 1, ior_to = 1;
  double eta() const { return ior_from / ior_to; }
};

/// The lists of solids that the rays of one tree of rays are inside of, outermost first. Lists are handles into storage
/// that grows with the tree and shrinks again with it, so that tracing does not allocate.
class MediumStacks {
public:
  struct List {
    std::uint32_t begin = 0, size = 0;
  };

  /// Storage that is in use; `release(mark)` gives back what was made since.
  std::uint32_t mark() const { return static_cast<std::uint32_t>(storage_.size()); }
  void release(std::uint32_t mark) { storage_.erase(storage_.begin() + mark, storage_.end()); }

  const Medium* begin(List list) const { return storage_.data() + list.begin; }
  const Medium* end(List list) const { return begin(list) + list.size; }
  bool holds(List list, std::uint64_t id) const { return place(list, id) < list.size; }
  /// How many solids of the list are around that one; its size where it is not in it.
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
  /// further out, as where solids overlap, is left without any bending.
  [[gnu::always_inline]] MediumTransition transition(List list, const Medium& it) const {
    const std::uint32_t i = place(list, it.id);
    if (i == list.size) return {MediumTransition::Kind::entering, top_ior(list), it.ior};
    if (i + 1 == list.size) return {MediumTransition::Kind::leaving, it.ior, top_ior({list.begin, list.size - 1})};
    return {MediumTransition::Kind::leaving_outer, top_ior(list), top_ior(list)};
  }
  /// The list behind that surface. A list that begins at `owned_from` or later is changed where it is, and so is
  /// whatever was made after it; others are copied if need be.
  List after(List list, const Medium& it, std::uint32_t owned_from);

  /// What passing from one list to one that has `it` more or less does; `it` need not be the innermost.
  MediumTransition transition(List before, List behind, const Medium& it) const;
  /// New lists: with one more solid, inside of the first `around` ones; and without one that it holds.
  List with(List list, std::uint32_t around, const Medium& it);
  List without(List list, std::uint64_t id);
  /// The list moved down to `begin`, where what is not needed any more begins. What came after it is given back.
  List moved(List list, std::uint32_t begin);

  /// ior of the other side by that of this side, as Fresnel's equation is given it: what lies behind a solid in the
  /// list is the innermost one, or nothing if it is alone.
  [[gnu::always_inline]] double fresnel_eta(List list, const Medium& it) const {
    if (list.size == 0) return it.ior;
    if (!holds(list, it.id)) return it.ior / top_ior(list);
    return (list.size == 1 ? 1 : top_ior(list)) / it.ior;
  }

private:
  std::vector<Medium> storage_;
};

} // namespace rt
