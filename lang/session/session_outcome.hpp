#pragma once

#include "lang/check/program.hpp"
#include "lang/evaluate/evaluator.hpp"
#include "lang/session/session_statement.hpp"

#include <string>

/// How a session responds to an input.
namespace rt::lang {

/// A value as a session prints it: vectors without digits that are only rounding errors.
std::string readable(const Value& value, const Program& program);

/// The outcome of a statement, in a few words: "placed sphere", "ball is a sphere", "background is now set"; empty for
/// a comment. `replaces`: it replaced another.
std::string outcome_of(const Statement& statement, bool replaces, Evaluator& evaluator, const Program& program);

} // namespace rt::lang
