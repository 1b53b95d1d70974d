#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt::tools {

/// A bound that `--gate NAME=VALUE` sets.
struct NamedNumber {
  std::string_view name;
  double* value;
};

/// Parses each NAME=VALUE into the number of that name. Throws UsageError for an unknown name or an invalid number.
void set_gates(const std::vector<std::string>& given, const std::vector<NamedNumber>& known);

} // namespace rt::tools
