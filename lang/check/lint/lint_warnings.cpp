#include "lang/check/lint/lint_warnings.hpp"

#include "lang/check/lint/rules.hpp"

#include <fmt/format.h>

namespace rt::lang::warnings {
namespace {

constexpr const char* take_out = "if it is not needed, remove it";

void never_placed(Report& report, Span place, std::string_view word, std::string label, std::string advice) {
  report.remark(lint_rule::never_placed.code, place, fmt::format("`{}` is bound and never placed", word),
                std::move(label), {{std::nullopt, std::move(advice)}});
}

void never_used(Report& report, Span place, std::string_view word, std::string label, std::string advice) {
  report.remark(lint_rule::never_used.code, place, fmt::format("`{}` is never used", word), std::move(label),
                {{std::nullopt, std::move(advice)}});
}

void unused_parameter(Report& report, Span place, std::string_view word) {
  if (word.starts_with('_')) return;
  report.remark(lint_rule::unused_parameter.code, place, fmt::format("the parameter `{}` is never used", word),
                "the value passed has no effect",
                {{std::nullopt, fmt::format("write `{0}` where its value is meant; if it must be there for its place, "
                                            "call it `_{0}`",
                                            word)}});
}

void looks_like_radians(Report& report, Span place, std::string label, std::vector<Note> notes = {}) {
  report.remark(lint_rule::radians.code, place, "this looks like radians, and angles are in degrees", std::move(label),
                std::move(notes));
}

} // namespace

void unused(Report& report, const Declaration& declaration, const SymbolTable& symbols) {
  const std::string_view word = symbols.name(declaration.symbol);
  const Span place = declaration.span;
  switch (declaration.what) {
  case Declaration::What::value:
    if (!declaration.known.is_thing() || !declaration.known.type->is_placeable())
      return never_used(report, place, word, "nothing reads it", take_out);
    return never_placed(
        report, place, word, "it is not in the scene",
        fmt::format("after `=` a thing is kept for later: to place it, write `{}` on a line of its own", word));
  case Declaration::What::def:
    return never_used(report, place, word, "no such thing is in the scene",
                      fmt::format("to place one, write `{} {{}}` on a line of its own", word));
  case Declaration::What::fn:
    return never_used(report, place, word, "nothing calls it", take_out);
  case Declaration::What::param:
    return never_used(report, place, word, "setting it changes nothing",
                      fmt::format("write `{}` where its value is meant", word));
  case Declaration::What::module:
    return never_used(report, place, word, "nothing from this file is used", take_out);
  case Declaration::What::parameter:
    return unused_parameter(report, place, word);
  case Declaration::What::local:
  case Declaration::What::unknown:
    return;
  }
}

void only_parts_read(Report& report, const Declaration& declaration, const SymbolTable& symbols) {
  const std::string_view word = symbols.name(declaration.symbol);
  never_placed(report, declaration.span, word, "only its properties are read",
               fmt::format("to place it, write `{}` on a line of its own", word));
}

void hidden_noun(Report& report, Span place, std::string_view word) {
  report.remark(lint_rule::hides_noun.code, place, fmt::format("the name `{0}` hides the thing `{0}`", word),
                fmt::format("from here on `{} {{ … }}` is a copy of this", word),
                {{std::nullopt, "choose another name"}});
}

void radians(Report& report, Span place, double degrees, std::string_view text) {
  looks_like_radians(report, place, fmt::format("write `{}`, or `{}rad`", degrees, text));
}

void turns_in_pi(Report& report, Span place) {
  looks_like_radians(report, place, "half a turn is 180 here, not pi",
                     {{std::nullopt, "write 180 for `pi` and 360 for `tau`; a number in radians takes the suffix "
                                     "`rad`, as in `1.5rad`"}});
}

void narrow_angle(Report& report, Span place, double number, double as_radians) {
  looks_like_radians(
      report, place,
      fmt::format("an angle of {0:g} degrees is very narrow; {0:g} radians would be `{1:.3g}`", number, as_radians));
}

} // namespace rt::lang::warnings
