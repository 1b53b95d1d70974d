#include "renderer/integrators/interiors.hpp"

namespace rt {

InteriorLists::List InteriorLists::make(const std::vector<Interior>& interiors) {
  const List list{mark(), static_cast<std::uint32_t>(interiors.size())};
  storage_.insert(storage_.end(), interiors.begin(), interiors.end());
  return list;
}

std::uint32_t InteriorLists::find(List list, std::uint64_t id) const {
  for (std::uint32_t i = 0; i < list.size; ++i)
    if (storage_[list.begin + i].id == id) return i;
  return list.size;
}

Passage InteriorLists::passage(List list, const Interior& it) const {
  const std::uint32_t i = find(list, it.id);
  if (i == list.size) return {Passage::Kind::entering, top_ior(list), it.ior};
  if (i + 1 == list.size) return {Passage::Kind::leaving, it.ior, top_ior({list.begin, list.size - 1})};
  return {Passage::Kind::leaving_outer, top_ior(list), top_ior(list)};
}

InteriorLists::List InteriorLists::after(List list, const Interior& it) {
  const std::uint32_t gone = find(list, it.id);
  if (gone + 1 == list.size) return {list.begin, gone};
  List result{mark(), 0};
  for (std::uint32_t i = 0; i < list.size; ++i)
    if (i != gone) storage_.push_back(Interior(storage_[list.begin + i]));
  if (gone == list.size) storage_.push_back(it);
  result.size = mark() - result.begin;
  return result;
}

double InteriorLists::fresnel_eta(List list, const Interior& it) const {
  if (list.size == 0) return it.ior;
  if (find(list, it.id) == list.size) return it.ior / top_ior(list);
  return (list.size == 1 ? 1 : top_ior(list)) / it.ior;
}

} // namespace rt
