#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace rt::lang {

class Heap;

/// What a value is. From `string` on it is on the heap and shared.
enum class ValueKind : std::uint8_t {
  unset,  ///< a name whose line has not been reached
  poison, ///< the result of an expression in error: whatever is computed from it is silently poison too
  none,
  boolean,
  number,
  vector, ///< a list of two or three numbers
  color,
  range,
  fade,
  choice,  ///< a word such as `orthographic`
  builtin, ///< a built-in function
  string,
  list, ///< any other list
  record,
  closure, ///< a function defined in the scene
  thing,
  module,
  formula, ///< what depends on the point that a function is compiled for
  // Never values, but on the heap like them:
  frame,
  chain,
  content
};

/// The header of everything on the heap. Cells are reference-counted, and immutable as far as values can
/// observe.
struct Cell {
  Heap* heap = nullptr;
  std::uint32_t references = 0;
  ValueKind kind = ValueKind::none;
  std::uint16_t depth = 0; ///< the nesting depth of lists, records and things in it
};

/// The memory of one evaluation: cells by size class, and the number of bytes in use. Freeing a long chain of cells is
/// not recursive. Everything allocated must be freed before the heap is.
class Heap {
public:
  Heap() = default;
  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;
  ~Heap();

  /// A new cell of type T followed by `extra` bytes; without references yet.
  template <class T, class... Arguments>
  T* make(std::size_t extra, Arguments&&... arguments) {
    T* cell = new (allocate(sizeof(T) + extra)) T(std::forward<Arguments>(arguments)...);
    cell->heap = this;
    cell->kind = T::cell_kind;
    return cell;
  }

  /// Called when the last reference to a cell is gone.
  void release(Cell* cell);

  /// Memory that cells own outside of the heap (the elements of a list).
  void charge(std::size_t bytes) { bytes_ += bytes; }
  void discharge(std::size_t bytes) { bytes_ -= bytes; }
  std::uint64_t bytes() const { return bytes_; }

private:
  static constexpr std::size_t granule = 16;
  static constexpr std::size_t largest = 512; // bigger cells come from `operator new`
  static constexpr std::size_t chunk_size = std::size_t{64} << 10;

  void* allocate(std::size_t bytes);
  void deallocate(void* memory, std::size_t bytes);
  void destroy(Cell* cell);

  struct Free {
    Free* next;
  };
  std::array<Free*, largest / granule + 1> free_{};
  std::vector<std::byte*> chunks_;
  std::byte* next_ = nullptr;
  std::byte* end_ = nullptr;
  std::vector<Cell*> dead_;
  bool is_draining_ = false;
  std::uint64_t bytes_ = 0;
};

/// Counts memory of the heap's user until it goes out of scope.
class Charge {
public:
  explicit Charge(Heap& heap) : heap_(heap) {}
  Charge(const Charge&) = delete;
  Charge& operator=(const Charge&) = delete;
  ~Charge() { heap_.discharge(bytes_); }
  void add(std::size_t bytes) {
    heap_.charge(bytes);
    bytes_ += bytes;
  }

private:
  Heap& heap_;
  std::size_t bytes_ = 0;
};

/// A counted reference to a cell, or none.
template <class T>
class Ref {
public:
  Ref() = default;
  explicit Ref(T* cell) : cell_(cell) { retain(); }
  Ref(const Ref& other) : cell_(other.cell_) { retain(); }
  Ref(Ref&& other) noexcept : cell_(std::exchange(other.cell_, nullptr)) {}
  Ref& operator=(Ref other) noexcept {
    std::swap(cell_, other.cell_);
    return *this;
  }
  ~Ref() {
    if (cell_ && --cell_->references == 0) cell_->heap->release(cell_);
  }

  T* get() const { return cell_; }
  T& operator*() const { return *cell_; }
  T* operator->() const { return cell_; }
  explicit operator bool() const { return cell_ != nullptr; }
  friend bool operator==(const Ref&, const Ref&) = default;

private:
  void retain() const {
    if (cell_) ++cell_->references;
  }
  T* cell_ = nullptr;
};

} // namespace rt::lang
