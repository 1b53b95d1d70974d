#pragma once

#include "lang/values/node_types.hpp"

#include <string>
#include <string_view>

namespace rt::lang {

/// What another language calls something, and what it is here; empty where the word is not known.
std::string dialect_name(std::string_view name);
std::string dialect_property(std::string_view property, const NodeType* type);

} // namespace rt::lang
