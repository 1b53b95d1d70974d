#include "lang/check/program.hpp"

#include <algorithm>

namespace rt::lang {

Program::Program() {
  types.intern(symbols);
  for (const NodeType& type : types.all()) {
    for (const Property& property : type.properties) {
      for (const std::string_view word : property.choices) {
        if (std::ranges::find(choices, word) == choices.end()) choices.push_back(word);
      }
    }
  }
}

} // namespace rt::lang
