#include "lang/check/errors/shared_errors.hpp"

#include <fmt/format.h>

#include <utility>

namespace rt::lang::errors {

Diagnostic no_value_yet(Span place, std::string message, std::string label, std::vector<Note> notes) {
  return make_error("E0203", place, std::move(message), std::move(label), std::move(notes));
}

Diagnostic no_property(Span place, std::string message, std::string label, std::vector<Note> notes) {
  return make_error("E0204", place, std::move(message), std::move(label), std::move(notes));
}

Diagnostic property_set_twice(Span place, std::string_view name, Span first) {
  return make_error("E0205", place, fmt::format("`{}` is set twice", name), {}, {{first, "first here"}});
}

Diagnostic two_forms(Span place, std::string_view name, Span other_place, std::string_view other) {
  return make_error("E0206", place, fmt::format("`{}` and `{}` are alternatives: use only one of them", other, name),
                    "leave one of them out", {{other_place, "the other one is here"}});
}

Diagnostic called_thing(Span place, std::string_view thing, std::string label) {
  return make_error("E0209", place, fmt::format("{} is a thing, and its properties are written in braces", thing),
                    std::move(label));
}

Diagnostic no_thing(Span place, std::string message, std::string label) {
  return make_error("E0210", place, std::move(message), std::move(label));
}

Diagnostic no_member(Span place, std::string message, std::string label) {
  return make_error("E0212", place, std::move(message), std::move(label));
}

Diagnostic too_deep(Span place, std::string message, std::string label) {
  return make_error("E0506", place, std::move(message), std::move(label));
}

} // namespace rt::lang::errors
