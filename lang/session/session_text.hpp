#pragma once

#include "lang/syntax/ast.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The text of a session's statements: how it is cut out of what was typed or read, and edited.
namespace rt::lang {

/// The text of one item with the comments that belong to it: those above it and the one behind it.
struct ItemText {
  std::string text;
  std::uint32_t line = 1; ///< of the text's beginning, in the source
};

/// Cuts a source into the texts of its items, in order; one more, if there are comments behind the last item, for them.
std::vector<ItemText> cut_items(std::string_view source, const Ast& ast, NodeList items);

/// A first line for lists: without comments, on one line, not too long.
std::string shortened(std::string_view text);

/// Whether the item edits what comes before it in the session: its innermost part is `Kind::previous`.
bool edits_previous(const Ast& ast, NodeId item);

/// The innermost part of an expression's chain of calls, members, overrides and indices: what it is a copy of.
NodeId innermost(const Ast& ast, NodeId node);

/// `text` with a property written into the thing at `node` of its tree, in the place of an earlier value or as a
/// further line. Nothing where the expression is nothing that a block can follow.
std::optional<std::string> with_property(std::string_view text, const Ast& ast, NodeId node, Symbol property,
                                         std::string_view property_name, std::string_view value);

/// `text` with every name `symbol` in the expression `node` replaced.
std::string with_name_replaced(std::string_view text, const Ast& ast, NodeId node, Symbol symbol,
                               std::string_view replacement);

} // namespace rt::lang
