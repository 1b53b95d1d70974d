#include "lang/check/errors/name_errors.hpp"

#include "lang/check/errors/shared_errors.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rt::lang::errors {
namespace {

void not_known(CheckContext& context, Span place, std::string message, std::string label) {
  context.report.error("E0201", place, std::move(message), std::move(label));
}

} // namespace

void unknown_name(CheckContext& context, Span place, Symbol name, const std::vector<std::string_view>& known) {
  const auto guess = nearest(context.name(name), known);
  not_known(context, place, fmt::format("unknown name `{}`", context.name(name)),
            guess ? fmt::format("did you mean `{}`?", *guess) : "not known here");
}

void unknown_choice(CheckContext& context, Span place, Symbol name, std::span<const std::string_view> choices) {
  const auto guess = nearest(context.name(name), choices);
  not_known(context, place, fmt::format("unknown name `{}`", context.name(name)),
            guess ? fmt::format("did you mean `{}`?", *guess)
                  : fmt::format("`{}` can be written here", fmt::join(choices, "`, `")));
}

void name_of_another_language(CheckContext& context, Span place, Symbol name, const std::string& here) {
  not_known(context, place, fmt::format("there is no `{}` in this language", context.name(name)), here);
}

void unquoted_string(CheckContext& context, Span place, Symbol name) {
  not_known(context, place, fmt::format("unknown name `{}`", context.name(name)),
            fmt::format("a string is written in quotes: '\"{}\"'", context.name(name)));
}

void name_bound_twice(CheckContext& context, Symbol name, Span first, Span second) {
  context.report.error("E0202", second, fmt::format("`{}` is bound twice in one block", context.name(name)),
                       "names never change: choose another one",
                       {{first, fmt::format("first bound here, on line {}", context.line(first))}});
}

void name_in_its_own_value(CheckContext& context, Span place, Symbol name, bool is_lambda) {
  const std::string_view word = context.name(name);
  std::vector<Note> notes;
  if (is_lambda)
    notes.push_back({std::nullopt, fmt::format("a function that calls itself is written `fn {}(…) = …`", word)});
  context.report.add(no_value_yet(place, fmt::format("`{}` has no value yet: its own line gives it one", word),
                                  "not known here", std::move(notes)));
}

void name_before_its_value(CheckContext& context, Span place, Symbol name, Span later) {
  context.report.add(no_value_yet(
      place, fmt::format("`{}` has no value yet: line {} gives it one", context.name(name), context.line(later)),
      "too early", {{later, "bound here"}}));
}

void name_hides_property(CheckContext& context, Span place, Symbol name, const Owner& owner) {
  const bool is_scene = owner.type == &context.program.types.scene();
  const std::string whose =
      is_scene ? "the scene" : fmt::format("`{}`", owner.def ? context.name(owner.def->name) : owner.type->name);
  context.report.error("E0207", place, fmt::format("`{}` is a name here, and nothing reads it", context.name(name)),
                       fmt::format("to set the property of {}, write `{}: …`", whose, context.name(name)));
}

void property_is_no_name(CheckContext& context, Span place, Symbol name, bool has_block) {
  const std::string_view word = context.name(name);
  std::string label = fmt::format("to set it, write `{}: …`", word);
  std::vector<Note> notes;
  if (!has_block) {
    label = "a property is not a value to compute with";
    notes.push_back({std::nullopt,
                     fmt::format("bind a name before the block, `r = …`, and write it in both places: `{}: r`", word)});
  }
  context.report.error("E0214", place, fmt::format("`{}` is a property here, not a name", word), std::move(label),
                       std::move(notes));
}

void name_of_another_block(CheckContext& context, Span place, Symbol name, Span bound) {
  const std::string_view word = context.name(name);
  const std::string advice =
      fmt::format("bound here; for a name that depends on a condition, write `{} = if … {{ … }} else {{ … }}`", word);
  context.report.error("E0215", place, fmt::format("`{}` is bound inside a block, and known only there", word),
                       "not known here", {{bound, advice}});
}

void parameter_hides_property(CheckContext& context, Span place, Symbol name) {
  context.report.error("E0211", place, fmt::format("a parameter of a `def` cannot be called `{}`", context.name(name)),
                       "every thing has a property of that name");
}

} // namespace rt::lang::errors
