#include "renderer/shading/media.hpp"

#include <algorithm>
#include <iterator>

namespace rt {

MediumStacks::List MediumStacks::after(List list, const Medium& it, std::uint32_t owned_from) {
  const std::uint32_t gone = place(list, it.id);
  if (gone + 1 == list.size) return {list.begin, gone};
  if (list.begin < owned_from) {
    const List copy{mark(), list.size};
    storage_.reserve(storage_.size() + list.size + 1);
    std::copy_n(storage_.begin() + list.begin, list.size, std::back_inserter(storage_));
    list = copy;
  }
  storage_.resize(list.begin + list.size);
  if (gone == list.size) {
    storage_.push_back(it);
    return {list.begin, list.size + 1};
  }
  storage_.erase(storage_.begin() + list.begin + gone);
  return {list.begin, list.size - 1};
}

MediumTransition MediumStacks::transition(List before, List behind, const Medium& it) const {
  using Kind = MediumTransition::Kind;
  const bool enters = behind.size > before.size;
  const List with_it = enters ? behind : before;
  const bool is_inmost = place(with_it, it.id) + 1 == with_it.size;
  const Kind kind =
      enters ? (is_inmost ? Kind::entering : Kind::entering_outer) : (is_inmost ? Kind::leaving : Kind::leaving_outer);
  return {kind, top_ior(before), top_ior(behind)};
}

MediumStacks::List MediumStacks::with(List list, std::uint32_t around, const Medium& it) {
  const List result{mark(), list.size + 1};
  storage_.reserve(storage_.size() + result.size);
  const auto copy = [&](std::uint32_t first, std::uint32_t count) {
    std::copy_n(storage_.begin() + list.begin + first, count, std::back_inserter(storage_));
  };
  copy(0, around);
  storage_.push_back(it);
  copy(around, list.size - around);
  return result;
}

MediumStacks::List MediumStacks::without(List list, std::uint64_t id) {
  const List result{mark(), list.size - 1};
  storage_.reserve(storage_.size() + list.size);
  std::copy_if(storage_.begin() + list.begin, storage_.begin() + list.begin + list.size, std::back_inserter(storage_),
               [&](const Medium& m) { return m.id != id; });
  return result;
}

MediumStacks::List MediumStacks::moved(List list, std::uint32_t begin) {
  std::copy_n(storage_.begin() + list.begin, list.size, storage_.begin() + begin);
  storage_.resize(begin + list.size);
  return {begin, list.size};
}

} // namespace rt
