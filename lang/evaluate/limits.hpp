#pragma once

#include <cstdint>

namespace rt::lang {

/// Bounds on what a scene may cost; exceeding one is a diagnostic with place and call stack.
struct Limits {
  std::uint64_t steps = 100'000'000;
  int recursion = 1'000;
  std::uint64_t objects = 20'000'000;
  std::uint64_t memory_bytes = std::uint64_t{8} << 30;
};

} // namespace rt::lang
