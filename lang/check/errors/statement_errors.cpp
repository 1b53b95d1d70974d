#include "lang/check/errors/statement_errors.hpp"

#include "lang/check/errors/shared_errors.hpp"
#include "lang/syntax/errors/syntax_codes.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rt::lang::errors {

void if_without_else(Report& report, Span place) {
  report.error("E0313", place, "an `if` that is a value needs an `else`", "no value where the condition is false");
}

void not_one_value(Report& report, Span place, std::string_view what, std::string_view why) {
  report.error("E0314", place, fmt::format("{} holds names and then one value", what), std::string(why));
}

void param_below_top_level(Report& report, Span place) {
  report.error("E0216", place, "`param` stands at the top level only", "here it could be bound with `=`");
}

void too_many_names_in_loop(Report& report, Span place) {
  report.add(too_deep(place, "there are too many names in this loop"));
}

void expect_below_top_level(Report& report, Span place) {
  report.error("E0217", place, "`expect` stands at the top level, or in a `for` or `if` there",
               "it is about the scene as a whole");
}

void claim_of_no_ray(Report& report, Span place, Claim claim) {
  report.error("E0218", place, fmt::format("`{}` needs a ray before it", spelling(claim)),
               "write `pixel(x, y)`, `image_point(x, y)` or `ray(origin, direction)`");
}

void file_cycle(Report& report, Span place, std::string_view how, const std::filesystem::path& path) {
  report.error("E0602", place, fmt::format("this file is being read already: it would {} itself", how),
               path.filename().string());
}

void file_outside_folder(Report& report, Span place, const std::filesystem::path& leads_to) {
  report.error("E0603", place, "this file is outside of the scene's folder",
               fmt::format("this leads to {}", leads_to.string()),
               {{std::nullopt, "files are read from the folder of the scene, and from the folders in it"},
                {std::nullopt, "`--include-root FOLDER` on the command line allows another folder"}});
}

void unreadable_file(Report& report, Span place, const std::string& name, const std::string& reason,
                     const std::string& guess) {
  std::string label = fmt::format("{}: {}", name, reason);
  if (!guess.empty()) label += fmt::format("; did you mean `{}`?", guess);
  report.error("E0601", place, "this file cannot be read", std::move(label));
}

void split_vector(Report& report, Span place, std::string_view property, std::string_view numbers) {
  report.malformed(vector_without_brackets(place, "a vector is written in square brackets",
                                           fmt::format("write `{}: [{}]`", property, numbers)));
}

void comment_for_division(Report& report, Span place, std::uint32_t line, std::string_view dividend,
                          std::string_view divisor) {
  if (Diagnostic* d = report.add(Severity::note, "N0005", place))
    d->message =
        fmt::format("`//` begins a comment: the value on line {} is `{}`; `floor({} / {})` divides and rounds down",
                    line, dividend, dividend, divisor);
}

void unused_define(Report& report, Span place, std::string_view name, const std::vector<std::string_view>& params) {
  const auto guess = nearest(name, params);
  std::vector<Note> notes;
  notes.push_back({std::nullopt, params.empty()
                                     ? fmt::format("it has none; `param {} = …` at the top level makes one", name)
                                     : fmt::format("it has {}", fmt::join(params, ", "))});
  report.error("E0604", place, fmt::format("the scene has no `param` called `{}`", name),
               guess ? fmt::format("did you mean `{}`?", *guess) : "", std::move(notes));
}

} // namespace rt::lang::errors
