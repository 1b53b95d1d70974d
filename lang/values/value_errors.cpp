#include "lang/values/value_errors.hpp"

#include <optional>
#include <utility>

namespace rt::lang::errors {
namespace {

constexpr std::string_view out_of_bounds_code = "E0302", not_finite_code = "E0303", flattened_code = "E0406";

Diagnostic make(std::string_view code, Span place, std::string message, std::string label, std::string advice) {
  std::vector<Note> notes;
  if (!advice.empty()) notes.push_back({std::nullopt, std::move(advice)});
  return make_error(code, place, std::move(message), std::move(label), std::move(notes));
}

} // namespace

Diagnostic wrong_property_value(Span place, std::string message, std::string label, std::string advice) {
  return make("E0301", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic value_out_of_bounds(Span place, std::string message, std::string label, std::string advice) {
  return make(out_of_bounds_code, place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic not_finite(Span place, std::string message, std::string label, std::string advice) {
  return make(not_finite_code, place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic flattened(Span place, std::string message, std::string label, std::string advice) {
  return make(flattened_code, place, std::move(message), std::move(label), std::move(advice));
}

bool is_about_value(const Diagnostic& diagnostic) {
  return diagnostic.code == out_of_bounds_code || diagnostic.code == not_finite_code ||
         diagnostic.code == flattened_code;
}

} // namespace rt::lang::errors
