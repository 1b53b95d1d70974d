#include "lang/session/session_outcome.hpp"

#include "lang/session/session_listing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace rt::lang {
namespace {

// "a sphere", "2.5", "a list".
std::string in_a_word(const Value& value, const Program& program) {
  constexpr std::size_t longest = 40;
  switch (value.kind()) {
  case ValueKind::thing:
  case ValueKind::closure:
  case ValueKind::builtin:
  case ValueKind::module:
    return describe(value);
  default: {
    std::string text = readable(value, program);
    return text.size() <= longest && text.find('\n') == std::string::npos ? text : describe(value);
  }
  }
}

// "sphere", "3 × box, ball".
std::string placed(const Statement& statement, Evaluator& evaluator, const Program& program) {
  constexpr std::size_t most = 4;
  const std::vector<ListedObject> objects = list_objects(statement, evaluator.scene(), program);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(objects.size(), most); ++i) {
    const ListedObject& object = objects[i];
    const std::string_view word = object.name.empty() ? object.kind : object.name;
    words.push_back(object.count == 1 ? std::string(word) : fmt::format("{} × {}", object.count, word));
  }
  if (objects.size() > most) words.push_back(fmt::format("{} more", objects.size() - most));
  return fmt::format("{}", fmt::join(words, ", "));
}

} // namespace

std::string readable(const Value& value, const Program& program) {
  if (!value.is(ValueKind::vector)) return format(value, program.symbols);
  const Vec3& v = value.vector();
  if (value.vector_size() == 2) return fmt::format("[{:.10g}, {:.10g}]", v.x, v.y);
  return fmt::format("[{:.10g}, {:.10g}, {:.10g}]", v.x, v.y, v.z);
}

std::string outcome_of(const Statement& statement, bool replaces, Evaluator& evaluator, const Program& program) {
  const std::string_view is = replaces ? "is now" : "is";
  const std::string_view name = statement.key == no_symbol ? "" : program.symbols.name(statement.key);
  switch (statement.kind) {
  case Kind::none:
    return "";
  case Kind::def:
    return fmt::format("{} {} a noun", name, is);
  case Kind::fn:
    return fmt::format("{} {} a function", name, is);
  case Kind::use:
    return fmt::format("{} {} a library", name, is);
  case Kind::property:
    return fmt::format("{} {} set", name, is);
  case Kind::bind:
  case Kind::param:
    if (statement.names.empty()) return "";
    return fmt::format("{} {} {}", name, is, in_a_word(evaluator.session_value(statement.names.front().slot), program));
  case Kind::expect:
    return "will be expected by `rtlang test`";
  default: {
    const std::string words = placed(statement, evaluator, program);
    if (statement.kind == Kind::include) return words.empty() ? "included" : "included, placed " + words;
    return words.empty() ? "placed nothing" : "placed " + words;
  }
  }
}

} // namespace rt::lang
