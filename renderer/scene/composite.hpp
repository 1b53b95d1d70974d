#pragma once

#include "renderer/scene/object.hpp"

namespace rt::scene {

/// Objects that are placed together; all their surfaces remain.
struct Group {
  static constexpr std::string_view noun = "group";
  std::vector<Object> members;
};

/// Solids combined into one. `unite` keeps only the outer boundary; `subtract` subtracts all further operands from the
/// first.
struct Combination {
  enum class Operation : std::uint8_t { unite, intersect, subtract };
  static constexpr std::string_view noun = "combination";
  Operation operation = Operation::unite;
  std::vector<Object> operands;
};

std::span<const Field> fields(const Group*);
std::span<const Field> fields(const Combination*);
std::optional<Problem> check(const Group&);
std::optional<Problem> check(const Combination&);

} // namespace rt::scene
