#include "lang/check/program.hpp"

#include <algorithm>

namespace rt::lang {

Program::Program() {
  nouns.intern(symbols);
  for (const Noun& noun : nouns.all()) {
    for (const Property& property : noun.properties) {
      for (const std::string_view word : property.choices) {
        if (std::ranges::find(choices, word) == choices.end()) choices.push_back(word);
      }
    }
  }
}

} // namespace rt::lang
