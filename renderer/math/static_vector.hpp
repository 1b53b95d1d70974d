#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <type_traits>

namespace rt {

/// Up to `Capacity` values without an allocation. They are constructed in place one by one: nothing is initialised up
/// front, and nothing is copied.
template <class T, std::size_t Capacity>
class StaticVector {
  static_assert(std::is_trivially_destructible_v<T>);

public:
  StaticVector() {} // not `= default`, which would let `{}` fill the storage with zeros
  StaticVector(const StaticVector&) = delete;
  StaticVector& operator=(const StaticVector&) = delete;

  /// Adds the value that `make` returns. There must be room.
  template <class Make>
  T& add(Make&& make) {
    T* const value = ::new (storage_.data() + size_ * sizeof(T)) T(make());
    ++size_;
    return *value;
  }

  std::size_t size() const { return size_; }
  T* begin() { return std::launder(reinterpret_cast<T*>(storage_.data())); }
  T* end() { return begin() + size_; }
  const T* begin() const { return std::launder(reinterpret_cast<const T*>(storage_.data())); }
  const T* end() const { return begin() + size_; }
  T& operator[](std::size_t i) { return begin()[i]; }
  const T& operator[](std::size_t i) const { return begin()[i]; }

private:
  alignas(T) std::array<std::byte, sizeof(T) * Capacity> storage_;
  std::size_t size_ = 0;
};

} // namespace rt
