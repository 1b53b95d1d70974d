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
/// said without running it: names, properties, arguments, duplicates. `program.main`, `program.library` and the defines
/// must be parsed. What is in error is marked so that evaluation passes over it in silence.
void check(Program& program, Files& files, Report& report);

/// The part of it that does not depend on the scene: the library, and the values of the command line.
void check_library(Program& program, Files& files, Report& report);

/// A file that `use` names, with those that it includes. `open_files` are the canonical paths of all that are being
/// read.
void check_module(ModuleInfo& module, Program& program, Files& files, Report& report,
                  std::vector<std::string>& open_files);

/// A name that a statement of a session has declared.
struct TopName {
  Meaning meaning = Meaning::value;
  Symbol name;
  Span span;
  std::uint32_t slot = 0; ///< or index of the function
  StaticType known;
};

/// A statement of a session as check sees it: to be checked, or checked before.
struct TopItem {
  Unit* unit = nullptr;        ///< null: it was checked before, and only its names matter
  std::vector<NodeId> nodes;   ///< its items: one, or things that were written one after the other
  std::vector<TopName> names;  ///< that it declares: given, or found
  std::vector<Symbol> uses;    ///< found: names of other statements, also of its own functions
  std::vector<Symbol> globals; ///< found: names that no statement declares
};

/// The statements of a session, in order. `slots` says how many of the session's frame are taken already, and then how
/// many are. Names of statements that are not among them are known all the same, as far as suggestions go:
/// `add_further_names`.
void check_session(std::span<TopItem> items, std::uint32_t& slots, const NameResolver::AddNames& add_further_names,
                   Program& program, Files& files, Report& report);

} // namespace rt::lang
