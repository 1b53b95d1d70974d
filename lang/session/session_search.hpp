#pragma once

#include "lang/session/session_change.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rt::lang {

/// What is found under a name.
struct Search {
  std::optional<std::size_t> found;
  std::string problem; ///< where nothing is, or nothing that is meant for sure
};

/// The statement that a name stands for: what declares it, the thing with this name, or the only one of its noun.
Search find_thing(const SessionCore& core, const SessionChange& change, std::string_view name);

} // namespace rt::lang
