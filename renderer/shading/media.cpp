#include "renderer/shading/media.hpp"

#include <algorithm>
#include <iterator>

namespace rt {

MediumStacks::List MediumStacks::after(List list, const Medium& it, std::uint32_t owned_from) {
  const std::uint32_t gone = find(list, it.id);
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

double MediumStacks::fresnel_eta(List list, const Medium& it) const {
  if (list.size == 0) return it.ior;
  if (find(list, it.id) == list.size) return it.ior / top_ior(list);
  return (list.size == 1 ? 1 : top_ior(list)) / it.ior;
}

} // namespace rt
