#include "lang/ide/reference.hpp"

#include "lang/builtins/builtins.hpp"
#include "lang/check/lint/rules.hpp"
#include "lang/library/library.hpp"
#include "lang/text/words.hpp"
#include "lang/values/css_colors.hpp"
#include "lang/values/node_types.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace rt::lang {
namespace {

constexpr std::array<std::string_view, 11> section_names = {
    "shapes", "common", "chain", "material", "library", "patterns", "lights", "camera", "scene", "builtins", "lint"};

std::string type_text(const Property& property) {
  switch (property.type) {
  case PropertyType::number:
    return property.is_textured() ? "number or pattern" : property.constraint.is_whole ? "whole number" : "number";
  case PropertyType::boolean:
    return "true or false";
  case PropertyType::vector:
    return "vector";
  case PropertyType::size:
    return "vector or number";
  case PropertyType::color:
    return property.is_textured() ? "colour, number or pattern" : "colour or number";
  case PropertyType::points:
    return "list of points";
  case PropertyType::choice:
    return fmt::format("{}", fmt::join(property.choices, " or "));
  case PropertyType::fade:
    return "fade";
  case PropertyType::resolution:
    return "[width, height]";
  case PropertyType::metal:
    return "metal or { n, k }";
  case PropertyType::absorb:
    return "{ color, distance }";
  case PropertyType::function:
    return "function of a point";
  case PropertyType::stops:
    return "list of stops";
  case PropertyType::material:
    return "material, colour or pattern";
  case PropertyType::text:
    return "string";
  }
  return {};
}

PropertyEntry entry(const Property& property) {
  return {property.name, type_text(property), std::string(property.default_text), std::string(property.help),
          property.form};
}

std::string_view section_of(Category category) {
  switch (category) {
  case Category::shape:
  case Category::group:
  case Category::combination:
    return "shapes";
  case Category::material:
    return "material";
  case Category::pattern:
    return "patterns";
  case Category::light:
    return "lights";
  case Category::camera:
    return "camera";
  case Category::scene:
    return "scene";
  }
  return {};
}

ReferenceEntry entry(const NodeType& type) {
  const bool is_scene = type.category == Category::scene;
  ReferenceEntry e{std::string(section_of(type.category)),
                   std::string(type.name),
                   is_scene ? "name: value, at the top level" : fmt::format("{} {{ … }}", type.name),
                   std::string(type.help),
                   {},
                   {}};
  for (const Property& p : type.properties) {
    const bool is_shared = type.is_shape() && p.common != Common::none;
    (is_shared ? e.common_properties : e.properties).push_back(entry(p));
  }
  return e;
}

// The `name = material { … }` lines of the standard library.
void add_library(std::vector<ReferenceEntry>& entries) {
  std::string_view rest = library_text();
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::size_t equals = line.find('=');
    if (line.starts_with("//") || equals == std::string_view::npos) continue;
    const std::string_view name = line.substr(0, line.find(' '));
    entries.push_back({"library", std::string(name), std::string(name), std::string(line.substr(equals + 2)), {}, {}});
  }
}

std::string signature_text(std::string_view before, std::string_view name, const Signature& signature) {
  return fmt::format("{}{}({})", before, name, signature.text());
}

// The separator of Markdown table cells must not occur in one.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

std::string property_rows(std::span<const PropertyEntry> properties) {
  std::string rows = "| property | takes | default | |\n|---|---|---|---|\n";
  for (const PropertyEntry& p : properties) {
    const std::string shown = p.default_text.empty() ? "" : fmt::format("`{}`", p.default_text);
    rows += fmt::format("| `{}` | {} | {} | {} |\n", p.name, cell(p.type), cell(shown), cell(p.help));
  }
  return rows;
}

std::string noun_tables(std::span<const ReferenceEntry> entries) {
  std::string text;
  for (const ReferenceEntry& e : entries) {
    text += fmt::format("\n**`{}`** — {}\n", e.name, e.help);
    if (!e.properties.empty()) text += "\n" + property_rows(e.properties);
  }
  return text;
}

} // namespace

std::string describe_property(const Property& property) {
  const PropertyEntry e = entry(property);
  return fmt::format("{}: {}{}{}\n  {}", e.name, e.type, e.default_text.empty() ? "" : " = ", e.default_text, e.help);
}

std::span<const std::string_view> reference_sections() {
  return section_names;
}

std::vector<ReferenceEntry> reference() {
  std::vector<ReferenceEntry> entries;
  const NodeTypes types;
  for (const NodeType& type : types.all()) entries.push_back(entry(type));
  entries.push_back(entry(types.scene()));
  ReferenceEntry common{"common", "shapes", "noun { … }", "what every shape takes", {}, {}};
  common.properties = entry(types.group()).common_properties;
  entries.push_back(common);
  for (const ChainMethod& m : chain_methods())
    entries.push_back(
        {"chain", std::string(m.name), signature_text("thing.", m.name, m.signature), std::string(m.help), {}, {}});
  add_library(entries);
  for (const BuiltinGroup& group : builtin_groups())
    for (const Builtin& b : group.rows)
      entries.push_back(
          {"builtins", std::string(b.name), signature_text("", b.name, b.signature), std::string(b.help), {}, {}});
  for (const Constant& c : constants())
    entries.push_back(
        {"builtins", std::string(c.name), fmt::format("{} = {}", c.name, c.value_text), std::string(c.help), {}, {}});
  const auto rank = [](const ReferenceEntry& e) {
    return std::ranges::find(section_names, e.section) - section_names.begin();
  };
  std::ranges::stable_sort(entries, {}, rank);
  return entries;
}

std::optional<ReferenceEntry> find_entry(std::string_view name) {
  for (ReferenceEntry& e : reference())
    if (e.name == name) return std::move(e);
  return std::nullopt;
}

std::vector<std::string> reference_names() {
  std::vector<std::string> names;
  for (const ReferenceEntry& e : reference()) {
    names.push_back(e.name);
    for (const auto* properties : {&e.properties, &e.common_properties})
      for (const PropertyEntry& p : *properties) names.emplace_back(p.name);
  }
  for (Word word{}; word <= Word::expect_; word = static_cast<Word>(static_cast<int>(word) + 1))
    if (is_reserved(word)) names.emplace_back(spelling(word));
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string describe(const ReferenceEntry& e) {
  std::string text = fmt::format("{}\n  {}\n", e.signature, e.help);
  const auto list = [&](std::span<const PropertyEntry> properties) {
    for (const PropertyEntry& p : properties) {
      const std::string shown = p.default_text.empty() ? "" : fmt::format(" (default {})", p.default_text);
      text += fmt::format("  {:<13} {}; {}{}\n", p.name, p.help, p.type, shown);
    }
  };
  list(e.properties);
  if (!e.common_properties.empty()) {
    text += "and, as every shape,\n";
    list(e.common_properties);
  }
  return text;
}

std::string describe_name(std::string_view name) {
  std::string text;
  for (const ReferenceEntry& e : reference())
    if (e.name == name) text += describe(e);
  text += describe_properties(name) + describe_keyword(name);
  if (const auto rgb = find_css_color(name)) text += fmt::format("{}: the colour #{:06x}\n", name, *rgb);
  return text;
}

std::string describe_properties(std::string_view name) {
  std::string text;
  for (const ReferenceEntry& entry : reference()) {
    for (const auto* properties : {&entry.properties, &entry.common_properties}) {
      for (const PropertyEntry& property : *properties) {
        if (property.name != name && fmt::format("{}.{}", entry.name, property.name) != name) continue;
        const std::string otherwise = property.default_text.empty() ? "" : fmt::format(" ({})", property.default_text);
        text += fmt::format("{}.{}: {}{}  {}\n", entry.name, property.name, property.type, otherwise, property.help);
      }
    }
  }
  return text;
}

std::string markdown(std::string_view section) {
  if (section == "lint") return lint_rules_markdown();
  std::vector<ReferenceEntry> entries;
  for (ReferenceEntry& e : reference())
    if (e.section == section) entries.push_back(std::move(e));
  if (section == "common" || section == "scene" || section == "camera" || section == "material")
    return property_rows(entries.front().properties);
  if (section == "shapes" || section == "patterns" || section == "lights") return noun_tables(entries);
  if (section == "library") {
    std::string rows = "| name | is |\n|---|---|\n";
    for (const ReferenceEntry& e : entries) rows += fmt::format("| `{}` | `{}` |\n", e.name, cell(e.help));
    return rows;
  }
  std::string rows = "| write | for |\n|---|---|\n";
  for (const ReferenceEntry& e : entries) rows += fmt::format("| `{}` | {} |\n", cell(e.signature), cell(e.help));
  return rows;
}

} // namespace rt::lang
