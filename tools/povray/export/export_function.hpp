#pragma once

#include "renderer/functions/function.hpp"
#include "tools/povray/export/sdl.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Functions in POV-Ray's language, whose functions are one expression each.
namespace rt::tools::povray {

/// One result of a function. POV-Ray has no names for parts of an expression: what is needed twice becomes a parameter
/// of a function that the one before it calls, and those are declared before, from the last to the first.
struct FunctionText {
  struct Declaration {
    std::string name, parameters, body;
  };
  std::vector<Declaration> declarations; ///< in the order in which POV-Ray must read them
  std::string expression;                ///< of x, y and z
};

/// Nothing where POV-Ray has no such function; `problem` then says why.
std::optional<FunctionText> function_text(const Function& function, std::size_t result, std::string& problem);

/// The largest value of a result, as far as that is known without looking at points.
double upper_bound(const Function& function, std::size_t result);

/// Writes `function { … }`, a pattern whose values are those of the text divided by `scale`, and held between 0 and 1;
/// its declarations last for that line only.
void write_function_pattern(Writer& out, const FunctionText& text, double scale);

} // namespace rt::tools::povray
