#pragma once

#include "lang/syntax/ast.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The text of a session's statements: how it is cut out of the input, and edited.
namespace rt::lang {

/// The text of one item with the comments that belong to it: those above it and the one after it.
struct ItemText {
  std::string text;
  std::uint32_t line = 1; ///< of the text's first line, in the source
};

/// Cuts a source into the texts of its items, in order; comments after the last item are one more.
std::vector<ItemText> cut_items(std::string_view source, const Ast& ast, NodeList items);

/// A first line for lists: without comments, on one line, not too long.
std::string shortened(std::string_view text);

/// Whether the item edits what precedes it in the session: its innermost part is `Kind::previous`.
bool edits_previous(const Ast& ast, NodeId item);

/// The innermost part of an expression's chain of calls, members, overrides and indices: what it is a copy of.
NodeId innermost(const Ast& ast, NodeId node);

/// `text` with a property set in the thing at `node` of its tree, replacing an earlier value or on a new line. Nothing
/// if the expression cannot be followed by a block.
std::optional<std::string> with_property(std::string_view text, const Ast& ast, NodeId node, Symbol property,
                                         std::string_view property_name, std::string_view value);

/// `text` with every name `symbol` in the expression `node` replaced.
std::string with_name_replaced(std::string_view text, const Ast& ast, NodeId node, Symbol symbol,
                               std::string_view replacement);

} // namespace rt::lang
