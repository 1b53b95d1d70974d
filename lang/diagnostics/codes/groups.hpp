#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <span>

/// The groups of the registry, one file each; a new code is one row there.
namespace rt::lang::codes {

std::span<const Code> syntax();       ///< E01xx: the text is not well formed
std::span<const Code> names();        ///< E02xx: names, properties, numbers of arguments
std::span<const Code> values();       ///< E03xx: types and values
std::span<const Code> things();       ///< E04xx: shapes, solids, materials, lights, cameras
std::span<const Code> limits();       ///< E05xx: steps, depth, memory, objects
std::span<const Code> files();        ///< E06xx: include, use, param
std::span<const Code> expectations(); ///< E07xx: what `rtlang test` finds
std::span<const Code> imports();      ///< E08xx, N08xx: other programs' scenes
std::span<const Code> lint();         ///< Wxxxx: what `rtlang lint` warns of
std::span<const Code> remarks();      ///< Nxxxx: notes

} // namespace rt::lang::codes
