#pragma once

#include "lang/session/session.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

/// The words that may stand in the place of the one before the cursor, sorted, and where that one begins.
struct SessionCompletion {
  std::size_t begin = 0;
  std::vector<std::string> words;
};

/// What may stand at the cursor of a text that is being typed: properties of the thing whose block it is in, values
/// that a property takes, keywords, nouns, functions, colours, and the session's names.
SessionCompletion complete(const Session& session, std::string_view text, std::size_t cursor);

/// All words that have an entry in the reference.
std::vector<std::string> documented_words(const Session& session);

} // namespace rt::lang
