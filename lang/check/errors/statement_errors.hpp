#pragma once

#include "lang/check/context.hpp"

#include <filesystem>
#include <string_view>

/// Check's errors about statements and files.
namespace rt::lang::errors {

void if_without_else(Report& report, Span place);
/// `what` contains bindings and then one value: "a function"; `why` is the reason this line does not fit.
void not_one_value(Report& report, Span place, std::string_view what, std::string_view why);
void param_below_top_level(Report& report, Span place);
void too_many_names_in_loop(Report& report, Span place);
void expect_below_top_level(Report& report, Span place);
/// `hits` or `misses` of something that is not a ray.
void claim_of_no_ray(Report& report, Span place, Claim claim);

/// A file that would include or use itself: `how` says which.
void file_cycle(Report& report, Span place, std::string_view how, const std::filesystem::path& path);
/// `leads_to` is the resolved path.
void file_outside_folder(Report& report, Span place, const std::filesystem::path& leads_to);
/// `guess` is the name that was probably intended, or empty.
void unreadable_file(Report& report, Span place, const std::string& name, const std::string& reason,
                     const std::string& guess);
/// `at: 1, 2, 3`.
void split_vector(Report& report, Span place, std::string_view property, std::string_view numbers);
/// `7 // 2`, on that line.
void comment_for_division(Report& report, Span place, std::uint32_t line, std::string_view dividend,
                          std::string_view divisor);
/// A value from the command line that no `param` takes.
void unused_define(Report& report, Span place, std::string_view name, const std::vector<std::string_view>& params);

} // namespace rt::lang::errors
