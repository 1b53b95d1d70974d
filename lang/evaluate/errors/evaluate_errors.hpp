#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <string>

/// Run-time errors: one function per code; the registry documents each.
namespace rt::lang::errors {

Diagnostic wrong_operand(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic no_condition(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic not_callable(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic not_iterable(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic no_element(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic wrong_argument(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic no_result(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic range_stands_still(Span place, std::string message, std::string label = {}, std::string advice = {});
/// Of what is known only while the picture is made.
Diagnostic not_known_yet(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic unused_value(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic open_in_combination(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic light_in_combination(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic camera_in_thing(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic second_camera(Span place, Span first);
Diagnostic second_sky(Span place, Span first);
Diagnostic takes_no_things(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic properties_disagree(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic media_disagree(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic not_movable(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic not_placeable(Span place, std::string message, std::string label = {}, std::string advice = {});
/// A scene without a thing; `keeps_things` if some are bound to names.
Diagnostic nothing_to_see(Span place, bool keeps_things);
Diagnostic too_many_steps(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic calls_too_deep(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic too_many_objects(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic too_much_memory(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic function_too_long(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic stopped(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic wrong_define(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic param_out_of_range(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic expectation_fails(Span place, std::string message, std::string label = {}, std::string advice = {});

// Notes
Diagnostic assumed_camera(Span place, std::string message);
Diagnostic assumed_light(Span place, std::string message);
Diagnostic empty_range(Span place);
/// The output of `print`.
Diagnostic printed(Span place, std::string text);

/// Whether other values might make it valid, so that it is no error where a line may never run.
bool depends_on_values(const Diagnostic& diagnostic);

} // namespace rt::lang::errors
