#pragma once

#include "lang/builtins/expect.hpp"
#include "lang/values/builtin.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace rt::lang {

namespace builtins {
std::span<const Builtin> maths();
std::span<const Builtin> vectors();
std::span<const Builtin> geometry();
std::span<const Builtin> lists();
std::span<const Builtin> colors();
std::span<const Builtin> randoms();
std::span<const Builtin> fades();
} // namespace builtins

std::span<const BuiltinGroup> builtin_groups();
/// What an `expect` may ask: functions that exist only there.
std::span<const Builtin> questions();
/// Index in `questions`.
std::optional<std::size_t> find_question(std::string_view name);
std::span<const Constant> constants();
std::span<const ChainMethod> chain_methods();

/// The rows of all groups, in sequence.
std::span<const Builtin* const> all_builtins();
/// Index in `all_builtins`.
std::optional<std::size_t> find_builtin(std::string_view name);
const Constant* find_constant(std::string_view name);
const ChainMethod* find_chain_method(std::string_view name);

} // namespace rt::lang
