#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Everything that has a name in the language, as data read from the tables that the checker and the evaluator use:
/// what `rtlang doc`, the session's `:doc` and the tables of the reference show.
namespace rt::lang {

struct Property;

/// A property of a thing.
struct PropertyEntry {
  std::string_view name;
  std::string type;         ///< "number", "point list", …
  std::string default_text; ///< empty if there is none
  std::string help;
  int form = 0; ///< properties of different forms (other than 0) are mutually exclusive
};

/// A noun, a function, a chain method, a constant or a ready-made material.
struct ReferenceEntry {
  std::string section; ///< one of `reference_sections`
  std::string name;
  std::string signature;                        ///< as it is written: "sphere { … }", "clamp(x: number, …)"
  std::string help;                             ///< one line
  std::vector<PropertyEntry> properties;        ///< of a noun: its own
  std::vector<PropertyEntry> common_properties; ///< of a shape: those that every shape has
};

/// The sections in the order of the reference: "shapes", "common", "chain", "material", "library", "patterns",
/// "lights", "camera", "scene", "builtins", "lint".
std::span<const std::string_view> reference_sections();

/// All entries, by section.
std::vector<ReferenceEntry> reference();
/// The first entry named so, a noun before all others; or none.
std::optional<ReferenceEntry> find_entry(std::string_view name);
/// Every name that `describe_name` knows but the colours', in order.
std::vector<std::string> reference_names();

/// A property of one thing: what it takes, its default, what it means.
std::string describe_property(const Property& property);
/// An entry as readable text.
std::string describe(const ReferenceEntry& entry);
/// All that there is to say of a name: entries (a mirror is a material and a step of a chain), properties, a word of
/// the grammar, a colour. Empty where the language has no such name.
std::string describe_name(std::string_view name);
/// All properties of this name, each with the thing that it belongs to; or the one, where the name is like
/// `sphere.radius`. Empty where nothing has one.
std::string describe_properties(std::string_view name);
/// A word of the grammar, with an example; empty for any other word.
std::string describe_keyword(std::string_view word);
/// A section as Markdown: what is between the `generated` marks of the reference. `section` must be one of them.
std::string markdown(std::string_view section);

} // namespace rt::lang
