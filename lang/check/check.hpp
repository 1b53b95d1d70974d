#pragma once

#include "lang/check/context.hpp"
#include "lang/check/names.hpp"
#include "lang/check/scopes.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rt::lang {

/// Resolves every name of the program to its slot, reads the files that it includes and uses, and reports what can be
/// found without running it: names, properties, arguments, duplicates. `program.main`, `program.library` and the
/// defines must be parsed. What is in error is marked so that evaluation skips it silently.
void check(Program& program, Files& files, Report& report);

/// The part that does not depend on the scene: the library, and the values from the command line.
void check_library(Program& program, Files& files, Report& report);

/// A file that `use` names, with those that it includes. `open_files` are the canonical paths of all files being
/// read.
void check_module(ModuleInfo& module, Program& program, Files& files, Report& report,
                  std::vector<std::string>& open_files);

/// A name declared by a statement of a session.
struct TopName {
  Meaning meaning = Meaning::value;
  Symbol name;
  Span span;
  std::uint32_t slot = 0; ///< or index of the function
  StaticType known;
};

/// A statement of a session: to be checked, or checked earlier.
struct TopItem {
  Unit* unit = nullptr;        ///< null: it was checked earlier, and only its names matter
  std::vector<NodeId> nodes;   ///< its items: one, or things written in succession
  std::vector<TopName> names;  ///< that it declares: an input, or found
  std::vector<Symbol> uses;    ///< found: names of other statements that it or its functions use
  std::vector<Symbol> globals; ///< found: names that no statement declares
};

/// The statements of a session, in order. `slots` is how many of the session's frame are taken,
/// before and after. Names of statements that are not among them are still suggested:
/// `add_further_names`.
void check_session(std::span<TopItem> items, std::uint32_t& slots, const NameResolver::AddNames& add_further_names,
                   Program& program, Files& files, Report& report);

} // namespace rt::lang
