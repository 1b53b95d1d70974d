#include "lang/evaluate/errors/evaluate_errors.hpp"

#include "lang/values/value_errors.hpp"

#include <optional>
#include <utility>

namespace rt::lang::errors {
namespace {

constexpr std::string_view no_element_code = "E0308";
constexpr std::string_view no_result_code = "E0310";
constexpr std::string_view range_stands_still_code = "E0311";
constexpr std::string_view unused_value_code = "E0312";
constexpr std::string_view properties_disagree_code = "E0407";

Diagnostic make(std::string_view code, Span place, std::string message, std::string label, std::string advice) {
  std::vector<Note> notes;
  if (!advice.empty()) notes.push_back({std::nullopt, std::move(advice)});
  return make_error(code, place, std::move(message), std::move(label), std::move(notes));
}

Diagnostic make_note(std::string_view code, Span place, std::string message, std::string label) {
  Diagnostic note = make_error(code, place, std::move(message), std::move(label));
  note.severity = Severity::note;
  return note;
}

} // namespace

Diagnostic wrong_operand(Span place, std::string message, std::string label, std::string advice) {
  return make("E0304", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic no_condition(Span place, std::string message, std::string label, std::string advice) {
  return make("E0305", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic not_callable(Span place, std::string message, std::string label, std::string advice) {
  return make("E0306", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic not_iterable(Span place, std::string message, std::string label, std::string advice) {
  return make("E0307", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic no_element(Span place, std::string message, std::string label, std::string advice) {
  return make(no_element_code, place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic wrong_argument(Span place, std::string message, std::string label, std::string advice) {
  return make("E0309", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic no_result(Span place, std::string message, std::string label, std::string advice) {
  return make(no_result_code, place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic range_stands_still(Span place, std::string message, std::string label, std::string advice) {
  return make(range_stands_still_code, place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic not_known_yet(Span place, std::string message, std::string label, std::string advice) {
  return make("E0315", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic unused_value(Span place, std::string message, std::string label, std::string advice) {
  return make(unused_value_code, place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic open_in_combination(Span place, std::string message, std::string label, std::string advice) {
  return make("E0401", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic light_in_combination(Span place, std::string message, std::string label, std::string advice) {
  return make("E0402", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic camera_in_thing(Span place, std::string message, std::string label, std::string advice) {
  return make("E0403", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic second_camera(Span place, Span first) {
  return make_error("E0404", place, "there is already a camera, and a scene has only one", {},
                    {{first, "the first one is here"}});
}

Diagnostic second_sky(Span place, Span first) {
  return make_error("E0412", place, "there is already a sky, and a scene has only one", {},
                    {{first, "the first one is here"}});
}

Diagnostic takes_no_things(Span place, std::string message, std::string label, std::string advice) {
  return make("E0405", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic properties_disagree(Span place, std::string message, std::string label, std::string advice) {
  return make(properties_disagree_code, place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic media_disagree(Span place, std::string message, std::string label, std::string advice) {
  return make("E0408", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic not_movable(Span place, std::string message, std::string label, std::string advice) {
  return make("E0409", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic not_placeable(Span place, std::string message, std::string label, std::string advice) {
  return make("E0410", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic nothing_to_see(Span place, bool keeps_things) {
  return make("E0411", place, "there is nothing to see in this scene",
              "a scene needs a thing on a line of its own, such as `sphere {}`",
              keeps_things ? "what is bound to a name is kept for later: the name on a line of its own places it" : "");
}

Diagnostic too_many_steps(Span place, std::string message, std::string label, std::string advice) {
  return make("E0501", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic calls_too_deep(Span place, std::string message, std::string label, std::string advice) {
  return make("E0502", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic too_many_objects(Span place, std::string message, std::string label, std::string advice) {
  return make("E0503", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic too_much_memory(Span place, std::string message, std::string label, std::string advice) {
  return make("E0504", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic function_too_long(Span place, std::string message, std::string label, std::string advice) {
  return make("E0507", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic stopped(Span place, std::string message, std::string label, std::string advice) {
  return make("E0505", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic wrong_define(Span place, std::string message, std::string label, std::string advice) {
  return make("E0605", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic param_out_of_range(Span place, std::string message, std::string label, std::string advice) {
  return make("E0606", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic expectation_fails(Span place, std::string message, std::string label, std::string advice) {
  return make("E0701", place, std::move(message), std::move(label), std::move(advice));
}

Diagnostic assumed_camera(Span place, std::string message) {
  return make_note("N0001", place, std::move(message), {});
}

Diagnostic assumed_light(Span place, std::string message) {
  return make_note("N0002", place, std::move(message), {});
}

Diagnostic empty_range(Span place) {
  return make_note("N0003", place, "this range is empty: it runs upwards, and its end lies below its beginning",
                   "to count down, write `by -1`");
}

Diagnostic printed(Span place, std::string text) {
  return make_note("N0004", place, std::move(text), {});
}

bool depends_on_values(const Diagnostic& d) {
  return is_about_value(d) || d.code == no_element_code || d.code == no_result_code ||
         d.code == range_stands_still_code || d.code == unused_value_code || d.code == properties_disagree_code;
}

} // namespace rt::lang::errors
