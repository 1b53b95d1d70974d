#pragma once

#include "lang/check/program.hpp"
#include "lang/session/session.hpp"
#include "lang/session/session_statement.hpp"

#include <cstdint>
#include <vector>

namespace rt::lang {

/// What a statement placed: consecutive things of one kind and name are one entry. Without numbers.
std::vector<ListedObject> list_objects(const Statement& statement, const scene::Scene& scene, const Program& program);

/// Numbers for what has no name, from 1 in document order: one for each item of a statement that places something
/// nameless.
class Numbering {
public:
  Numbering(const scene::Scene& scene, const Program& program) : scene_(scene), program_(program) {}

  struct Range {
    std::uint64_t first = 0, count = 0;
    bool holds(std::uint64_t number) const { return number >= first && number - first < count; }
  };
  /// Of the next statement.
  Range next(const Statement& statement);

private:
  const scene::Scene& scene_;
  const Program& program_;
  std::uint64_t last_ = 0;
};

} // namespace rt::lang
