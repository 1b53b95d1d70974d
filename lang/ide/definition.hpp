#pragma once

#include "lang/analyse.hpp"

#include <cstdint>
#include <optional>
#include <vector>

/// Where the names of a text are declared and used. The analysis must have kept its references
/// (`AnalyseOptions::keeps_references`); a place is one in, or directly after, a name.
namespace rt::lang {

/// Where the name at a place is declared, or the beginning of the file that it names. Nothing if there is no name, or
/// one that the language itself declares.
std::optional<Span> find_definition(const Analysis& analysis, FileId file, std::uint32_t place);

/// All places that refer to the same thing, including the declaration, file by file.
std::vector<Span> find_references(const Analysis& analysis, FileId file, std::uint32_t place);

} // namespace rt::lang
