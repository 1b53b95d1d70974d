#pragma once

#include "lang/session/session_change.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rt::lang {

/// What is found under a name.
struct Search {
  std::optional<std::size_t> found;
  std::uint64_t item = 0; ///< which of the statement's items, where it stands for many
  std::string problem;    ///< where nothing is, or nothing that is meant for sure
  std::string advice;
};

/// The statement that a name stands for: what declares it, the thing with this name, the only one of its noun, or what
/// has this number in `:list`.
Search find_thing(SessionCore& core, const SessionChange& change, std::string_view name);

/// A number that `:list` shows; none for what is not written as one.
std::optional<std::uint64_t> list_number(std::string_view text);

} // namespace rt::lang
