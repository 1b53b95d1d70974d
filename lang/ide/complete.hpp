#pragma once

#include "lang/analyse.hpp"
#include "lang/session/session.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

/// The words that may replace the one before the cursor, and where that one begins. What belongs to the context comes
/// first (properties of the block, values of the property), then things and names, then functions; each
/// alphabetically.
struct WordCompletion {
  std::size_t begin = 0;
  std::vector<std::string> words;
  bool is_path = false; ///< the path of a scene file is being typed, from `begin` on: no words
};

/// The completions at the cursor of a text that is being typed: properties of the thing whose block it is in, values
/// that a property takes, keywords, nouns, functions, colours, and the session's names.
WordCompletion complete(const Session& session, std::string_view text, std::size_t cursor);
/// The same at a place in an analysed file, errors and all, with the names visible there.
WordCompletion complete(const Analysis& analysis, FileId file, std::uint32_t place);

/// All words that have an entry in the reference.
std::vector<std::string> documented_words(const Session& session);

} // namespace rt::lang
