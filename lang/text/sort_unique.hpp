#pragma once

#include <algorithm>
#include <vector>

namespace rt::lang {

/// A set as a sorted vector.
template <class T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  values.shrink_to_fit();
}

} // namespace rt::lang
