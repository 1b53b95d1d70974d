#pragma once

#include "lang/check/program.hpp"
#include "lang/evaluate/evaluator.hpp"
#include "lang/session/session_statement.hpp"

#include <string>

/// What a session answers to what was typed.
namespace rt::lang {

/// A value as a session prints it: vectors without the digits that only rounding left in them.
std::string readable(const Value& value, const Program& program);

/// What came of a statement, in a few words: "placed sphere", "ball is a sphere", "background is now set"; empty for a
/// comment. `replaces`: it took another's place.
std::string outcome_of(const Statement& statement, bool replaces, Evaluator& evaluator, const Program& program);

} // namespace rt::lang
