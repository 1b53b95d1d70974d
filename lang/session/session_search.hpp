#pragma once

#include "lang/session/session_change.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rt::lang {

/// The result of a search by name.
struct Search {
  std::optional<std::size_t> found;
  std::uint64_t item = 0; ///< which of the statement's items, if it represents many
  std::string problem;    ///< if nothing is found, or the name is ambiguous
  std::string advice;
};

/// The statement that a name refers to: what declares it, the thing with this name, the only one of its noun, or what
/// has this number in `:list`.
Search find_thing(SessionCore& core, const SessionChange& change, std::string_view name);

/// A number that `:list` shows; none if the text is not a number.
std::optional<std::uint64_t> list_number(std::string_view text);

} // namespace rt::lang
