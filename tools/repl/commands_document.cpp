#include "lang/check/program.hpp"
#include "lang/ide/reference.hpp"
#include "lang/values/node_types.hpp"
#include "renderer/image/file.hpp"
#include "tools/repl/commands.hpp"
#include "tools/repl/shell.hpp"
#include "tools/terminal/swatch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>

namespace rt::tools {
namespace {

namespace fs = std::filesystem;

std::optional<std::size_t> version_number_of(Shell& shell, std::string_view text) {
  std::size_t number = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  if (parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() && number < shell.session().versions().size())
    return number;
  shell.fail(fmt::format("`{}` is not one of the numbers that :history shows", text));
  return std::nullopt;
}

// Its name, or the numbers that refer to it.
std::string label_of(const lang::ListedObject& object) {
  if (!object.name.empty()) return object.name;
  if (object.last_number > object.first_number) return fmt::format("{}-{}", object.first_number, object.last_number);
  return std::to_string(object.first_number);
}

bool list(Shell& shell, std::string_view) {
  const std::vector<lang::ListedObject> objects = shell.session().objects();
  if (objects.empty()) {
    shell.print("the scene is empty\n");
    return true;
  }
  std::size_t label_width = 4, kind_width = 4;
  for (const lang::ListedObject& object : objects) {
    label_width = std::max(label_width, label_of(object).size());
    kind_width = std::max(kind_width, object.kind.size());
  }
  std::string text;
  for (const lang::ListedObject& object : objects) {
    const std::string times = object.count > 1 ? fmt::format("  (and {} more)", object.count - 1) : "";
    text += fmt::format("{:<{}}  {:<{}}  {}{}\n", label_of(object), label_width, object.kind, kind_width, object.place,
                        times);
  }
  shell.print(text);
  return true;
}

// The document as it would be saved, with line numbers in an interactive session.
bool text(Shell& shell, std::string_view) {
  const std::string document = shell.session().formatted();
  if (!shell.options().is_interactive) {
    shell.print(document);
    return true;
  }
  std::string numbered;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < document.size();) {
    const std::size_t end = std::min(document.find('\n', begin), document.size());
    numbered += dim(fmt::format("{:>4}", ++number), shell.output().uses_color) + "  " +
                document.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  shell.print(numbered.empty() ? "the document is empty\n" : numbered);
  return true;
}

// The properties of a thing that can be set, or what is wrong with its name.
bool explain_properties(Shell& shell, std::string_view name) {
  const std::vector<std::string> properties = shell.session().properties_of(name);
  if (properties.empty())
    return shell.fail(fmt::format("there is no thing `{}` in the scene; for example `:set ball.radius 2`", name));
  shell.print(fmt::format("{} takes {}: as in `:set {}.{} VALUE`\n", name, fmt::join(properties, ", "), name,
                          properties.front()));
  return true;
}

// What to say if a value is missing: what the property takes.
bool explain_target(Shell& shell, std::string_view target) {
  const lang::NodeType& scene = shell.session().program().types.scene();
  const std::size_t dot = target.find('.');
  const bool is_of_scene = dot == std::string_view::npos;
  if (is_of_scene && !scene.find(target)) return explain_properties(shell, target);
  const std::string_view name = is_of_scene ? "" : target.substr(0, dot);
  const std::string_view property = is_of_scene ? target : target.substr(dot + 1);
  const lang::NodeType* type = is_of_scene ? &scene : shell.session().noun_of(name);
  if (const auto id = type ? type->find(property) : std::nullopt) {
    const std::string owner = is_of_scene ? "" : fmt::format("{}.", name);
    shell.print(fmt::format("{}{}\n", owner, lang::describe_property(type->properties[*id])));
    return true;
  }
  const lang::Program& program = shell.session().program();
  const lang::FunctionInfo* def = is_of_scene ? nullptr : shell.session().def_of(name);
  const auto parameter = def ? def->find(program.symbols.find(property)) : std::nullopt;
  if (!parameter) return explain_properties(shell, name);
  const lang::NodeId otherwise = def->parameters[*parameter].default_value;
  shell.print(fmt::format("{}: a parameter of {}, {}\n", target, program.symbols.name(def->name),
                          otherwise == lang::no_node
                              ? "which must be given"
                              : fmt::format("default {}", program.sources.text(def->unit->ast.span(otherwise)))));
  return true;
}

bool set(Shell& shell, std::string_view arguments) {
  if (arguments.empty()) return shell.fail("as in `:set ball.radius 2`");
  const std::size_t space = arguments.find_first_of(" \t\n");
  if (space == std::string_view::npos) return explain_target(shell, arguments);
  return shell.report(shell.session().set(arguments.substr(0, space), trimmed(arguments.substr(space))));
}

bool remove(Shell& shell, std::string_view arguments) {
  if (arguments.empty()) return shell.fail("as in `:remove ball`, or `:remove 2` for what :list numbers");
  return shell.report(shell.session().remove(arguments));
}

std::string where(const Shell& shell, lang::Session& session) {
  const lang::SessionVersion& version = session.versions()[session.version()];
  return dim(fmt::format("at {}: {}", session.version(), version.description.empty() ? "nothing" : version.description),
             shell.output().uses_color) +
         "\n";
}

// What changed in a version.
std::string deed(Shell& shell, std::size_t version) {
  return shell.session().versions()[version].description;
}

bool undo(Shell& shell, std::string_view) {
  const std::size_t undone = shell.session().version();
  if (!shell.session().undo()) return shell.fail("there is nothing to undo");
  shell.print(dim(fmt::format("undone: {}", deed(shell, undone)), shell.output().uses_color) + "\n");
  return true;
}

bool redo(Shell& shell, std::string_view) {
  if (!shell.session().redo()) return shell.fail("there is nothing to redo");
  shell.print(dim(fmt::format("redone: {}", deed(shell, shell.session().version())), shell.output().uses_color) + "\n");
  return true;
}

bool history(Shell& shell, std::string_view) {
  const auto& versions = shell.session().versions();
  std::string text;
  for (std::size_t i = 0; i < versions.size(); ++i) {
    const bool is_sequel = i == 0 || versions[i].parent + 1 == i;
    text += fmt::format("{} {:>3}  {}{}\n", i == shell.session().version() ? '>' : ' ', i,
                        versions[i].description.empty() ? "(nothing)" : versions[i].description,
                        is_sequel ? "" : fmt::format("   (from {})", versions[i].parent));
  }
  shell.print(text);
  return true;
}

bool at(Shell& shell, std::string_view arguments) {
  const auto version = version_number_of(shell, arguments);
  if (!version) return false;
  shell.session().go_to(*version);
  shell.print(where(shell, shell.session()));
  return true;
}

bool diff(Shell& shell, std::string_view arguments) {
  const std::vector<std::string> words = words_of(arguments);
  if (words.empty() || words.size() > 2) return shell.fail("as in `:diff 2 5`, with numbers that :history shows");
  const auto from = version_number_of(shell, words[0]);
  const auto to = words.size() == 2 ? version_number_of(shell, words[1]) : std::optional(shell.session().version());
  if (!from || !to) return false;
  const std::string text = shell.session().diff(*from, *to);
  shell.print(text.empty() ? "no difference\n" : text);
  return true;
}

bool load(Shell& shell, std::string_view arguments) {
  const std::vector<std::string> words = words_of(arguments);
  if (words.size() != 1) return shell.fail("as in `:load scene.rtl`");
  try {
    if (!shell.report(shell.session().load(words[0]))) return false;
  } catch (const std::system_error& error) {
    return shell.fail(fmt::format("cannot read `{}`: {}", words[0], error.code().message()));
  }
  shell.became_saved(words[0]);
  return true;
}

// The document's includes are looked up where it is saved.
void warn_of_includes(Shell& shell, const std::string& path, const std::string& folder) {
  std::error_code error;
  const fs::path saved = fs::weakly_canonical(path, error).parent_path();
  if (error || fs::equivalent(saved, folder, error) || !shell.session().includes_files()) return;
  shell.fail(fmt::format("the files it includes are in {}, but will be looked up in {}", folder, saved.string()));
}

bool save(Shell& shell, std::string_view arguments) {
  const std::vector<std::string> words = words_of(arguments);
  if (words.size() > 1) return shell.fail("as in `:save scene.rtl`");
  std::string path = words.empty() ? shell.path() : words[0];
  if (path.empty()) return shell.fail("give a file name, as in `:save scene.rtl`");
  if (!words.empty() && path.find('.', path.rfind('/') + 1) == std::string::npos) path += ".rtl";
  try {
    replace_file(path, shell.session().formatted());
  } catch (const std::system_error& error) {
    return shell.fail(error.what());
  }
  const std::string folder = shell.session().folder();
  shell.became_saved(path);
  shell.print(dim(fmt::format("saved as {}", path), shell.output().uses_color) + "\n");
  warn_of_includes(shell, path, folder);
  return true;
}

bool reset(Shell& shell, std::string_view) {
  return shell.report(shell.session().reset());
}

} // namespace

std::span<const ShellCommand> document_commands() {
  static constexpr ShellCommand table[] = {
      {"list", "", "lists the things in the scene: name or number, kind, place", ArgumentKind::none, list},
      {"text", "", "shows the document as :save would write it", ArgumentKind::none, text},
      {"set", "NAME.PROP VALUE", "changes a property; without VALUE, says what it takes", ArgumentKind::property, set},
      {"remove", "NAME", "removes a thing or a name that nothing else uses", ArgumentKind::thing, remove},
      {"undo", "", "undoes the last change", ArgumentKind::none, undo},
      {"redo", "", "redoes what was undone", ArgumentKind::none, redo},
      {"history", "", "lists all states of the scene by number", ArgumentKind::none, history},
      {"at", "N", "goes to one of these states", ArgumentKind::none, at},
      {"diff", "N [M]", "shows what changed from one to another", ArgumentKind::none, diff},
      {"load", "FILE", "replaces the scene by a file's", ArgumentKind::file, load},
      {"save", "[FILE]", "saves the scene as a formatted file", ArgumentKind::file, save},
      {"reset", "", "starts over (:undo brings it back)", ArgumentKind::none, reset},
  };
  return table;
}

} // namespace rt::tools
