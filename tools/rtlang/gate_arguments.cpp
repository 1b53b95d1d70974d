#include "tools/rtlang/gate_arguments.hpp"

#include "tools/terminal/exit_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace rt::tools {

void set_gates(const std::vector<std::string>& given, const std::vector<NamedNumber>& known) {
  for (const std::string& text : given) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw UsageError(fmt::format("--gate takes NAME=VALUE, not `{}`", text));
    const std::string_view name = std::string_view(text).substr(0, equals),
                           value = std::string_view(text).substr(equals + 1);
    const auto found = std::find_if(known.begin(), known.end(), [&](const NamedNumber& n) { return n.name == name; });
    if (found == known.end()) {
      std::string names;
      for (const NamedNumber& n : known) names += (names.empty() ? "" : ", ") + std::string(n.name);
      throw UsageError(fmt::format("unknown gate `{}`; the gates are {}", name, names));
    }
    const auto result = std::from_chars(value.data(), value.data() + value.size(), *found->value);
    if (result.ec != std::errc() || result.ptr != value.data() + value.size())
      throw UsageError(fmt::format("the gate `{}` takes a number, not `{}`", name, value));
  }
}

} // namespace rt::tools
