#include "lang/values/heap.hpp"

#include "lang/values/formula.hpp"
#include "lang/values/thing.hpp"

#include <cassert>

namespace rt::lang {

Heap::~Heap() {
  for (std::byte* chunk : chunks_) ::operator delete(chunk);
}

void* Heap::allocate(std::size_t bytes) {
  bytes_ += bytes;
  if (bytes > largest) return ::operator new(bytes);
  const std::size_t index = (bytes + granule - 1) / granule;
  if (Free* cell = free_[index]) {
    free_[index] = cell->next;
    return cell;
  }
  const std::size_t size = index * granule;
  if (static_cast<std::size_t>(end_ - next_) < size) {
    next_ = static_cast<std::byte*>(::operator new(chunk_size));
    end_ = next_ + chunk_size;
    chunks_.push_back(next_);
  }
  std::byte* memory = next_;
  next_ += size;
  return memory;
}

void Heap::deallocate(void* memory, std::size_t bytes) {
  bytes_ -= bytes;
  if (bytes > largest) {
    ::operator delete(memory);
    return;
  }
  const std::size_t index = (bytes + granule - 1) / granule;
  free_[index] = new (memory) Free{free_[index]};
}

void Heap::release(Cell* cell) {
  dead_.push_back(cell);
  if (is_draining_) return;
  is_draining_ = true;
  while (!dead_.empty()) {
    Cell* next = dead_.back();
    dead_.pop_back();
    destroy(next);
  }
  is_draining_ = false;
}

void Heap::destroy(Cell* cell) {
  const auto end = [&]<class T>(T* typed, std::size_t extra) {
    typed->~T();
    deallocate(typed, sizeof(T) + extra);
  };
  switch (cell->kind) {
  case ValueKind::string:
    discharge(static_cast<String*>(cell)->text.capacity());
    return end(static_cast<String*>(cell), 0);
  case ValueKind::list:
    discharge(static_cast<List*>(cell)->items.capacity() * sizeof(Value));
    return end(static_cast<List*>(cell), 0);
  case ValueKind::record:
    return end(static_cast<Record*>(cell), 0);
  case ValueKind::closure:
    return end(static_cast<Closure*>(cell), 0);
  case ValueKind::thing:
    return end(static_cast<Thing*>(cell), 0);
  case ValueKind::module:
    return end(static_cast<Module*>(cell), 0);
  case ValueKind::formula:
    return end(static_cast<Formula*>(cell), 0);
  case ValueKind::frame:
    return end(static_cast<Frame*>(cell), static_cast<Frame*>(cell)->size * sizeof(Value));
  case ValueKind::chain:
    return end(static_cast<Chain*>(cell), 0);
  case ValueKind::content:
    return end(static_cast<Content*>(cell), 0);
  default:
    assert(false);
  }
}

} // namespace rt::lang
