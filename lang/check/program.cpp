#include "lang/check/program.hpp"

#include <algorithm>

namespace rt::lang {

Program::Program() {
  types.intern(symbols);
  const auto add_choices = [this](const NodeType& type) {
    for (const Property& property : type.properties) {
      for (const std::string_view word : property.choices) {
        if (std::ranges::find(choices, word) == choices.end()) choices.push_back(word);
      }
    }
  };
  for (const NodeType& type : types.all()) add_choices(type);
  add_choices(types.scene());
}

} // namespace rt::lang
