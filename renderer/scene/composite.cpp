#include "renderer/scene/composite.hpp"

namespace rt::scene {

std::span<const Field> fields(const Group*) {
  return {};
}
std::span<const Field> fields(const Combination*) {
  return {};
}

std::optional<Problem> check(const Group&) {
  return std::nullopt;
}

std::optional<Problem> check(const Combination& combination) {
  if (!combination.operands.empty()) return std::nullopt;
  switch (combination.operation) {
  case Combination::Operation::unite:
    return std::nullopt; // of nothing: nothing
  case Combination::Operation::intersect:
    return Problem{"", "an intersection needs at least one solid"};
  case Combination::Operation::subtract:
    return Problem{"", "a difference needs a solid to subtract from"};
  }
  return std::nullopt;
}

} // namespace rt::scene
