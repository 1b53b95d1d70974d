#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/values/node_types.hpp"

#include <span>
#include <string>
#include <string_view>

namespace rt::lang {

/// The equivalent here of another language's name for something; empty if the name is not known.
std::string dialect_name(std::string_view name);
std::string dialect_property(std::string_view property, const NodeType* type);

/// What to write instead of a property that `whose` thing of this type does not have: added as label and note.
void advise_on_property(Diagnostic& d, std::string_view whose, std::string_view property, const NodeType& type,
                        std::span<const std::string_view> names);

} // namespace rt::lang
