#pragma once

#include "lang/check/context.hpp"

namespace rt::lang {

/// Whether the owner of the block has the property that `item` sets; records in the item which one it is.
void check_property(CheckContext& context, Unit& unit, NodeId item, const Owner& owner);
/// Properties that are set twice in a block, or in two forms.
void check_duplicates(CheckContext& context, const Unit& unit, NodeId block, const Owner& owner);
/// Fields of a record that are specified twice.
void check_record_fields(CheckContext& context, const Unit& unit, NodeId record);
/// Only properties, each once and of one form: evaluation need not check anything else.
bool is_simple_block(const Unit& unit, NodeId block, const NodeType& type);

} // namespace rt::lang
