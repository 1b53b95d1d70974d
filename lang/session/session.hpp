#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/load.hpp"
#include "lang/text/source.hpp"
#include "renderer/math/color.hpp"
#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

struct FunctionInfo;
struct NodeType;
struct Program;

/// The value of an expression typed on its own.
struct PrintedValue {
  std::string text;
  std::optional<Color> color; ///< of a colour, to be shown beside its text
};

/// The result of one input. Unless it is accepted the session is unchanged.
struct SessionResult {
  bool is_accepted = false;
  std::string problem;                 ///< a sentence, if something other than a statement's text is wrong
  std::vector<std::string> advice;     ///< hints about the problem
  std::vector<Diagnostic> diagnostics; ///< errors if it is not accepted; else warnings and notes
  std::vector<std::string> changes;    ///< what happened to the document, a sentence each
  std::vector<PrintedValue> values;
  std::vector<Diagnostic> printed; ///< by `print`, in order: notes
};

/// A thing of the scene as `:list` shows it.
struct ListedObject {
  std::string name; ///< its `name`, or the name it is bound to; else empty
  std::string kind; ///< "sphere", "table"
  std::string place;
  std::uint64_t count = 1; ///< how many such things the same statement placed in succession
  /// The numbers that `set` and `remove` accept in place of a name: one, except for things so similar that they are
  /// stored together. 0: it has a name.
  std::uint64_t first_number = 0, last_number = 0;
};

/// Consecutive objects of the scene, with a stamp that identifies their content.
struct SceneRange {
  std::uint32_t begin = 0, end = 0;
  std::uint64_t stamp = 0;
};

/// How much work was done since the session began: an unchanged statement costs 0.
struct SessionCounters {
  std::uint64_t statements_parsed = 0;
  std::uint64_t statements_evaluated = 0;
  std::uint64_t objects_evaluated = 0;
};

/// A state of the document.
struct SessionVersion {
  std::string description; ///< what led to it: "sphere { radius: 2 }", ":remove ball"
  std::size_t parent = 0;  ///< the version it was made from; itself for the first one
};

/// A scene built statement by statement. What is submitted is the document: each accepted input joins it, is evaluated
/// once, and again only when a name it uses has changed. Errors change nothing. Every state of the document is kept and
/// can be restored.
class Session {
public:
  /// Relative includes are resolved against `folder`.
  explicit Session(std::string folder, LoadOptions options = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// One or more statements or expressions, as typed.
  SessionResult submit(std::string_view text);
  /// Replaces the document by that of a file. Throws what `load_file` throws.
  SessionResult load(const std::string& path);
  /// Sets a property in the statement that binds or places the thing with this name: `target` is "NAME.property", or
  /// "NUMBER.property" with a number from `objects()`.
  SessionResult set(std::string_view target, std::string_view value);
  /// Removes a binding, a definition or a placed thing, by name or number, unless others use it.
  SessionResult remove(std::string_view name);
  SessionResult reset();

  bool undo();
  bool redo();
  /// Goes back (or forward) to a version.
  bool go_to(std::size_t version);
  std::size_t version() const;
  const std::vector<SessionVersion>& versions() const;

  /// The document's text at a version, as typed.
  std::string text() const { return text(version()); }
  std::string text(std::size_t version) const;
  /// As a scene file, in the formatter's layout.
  std::string formatted() const;
  /// The statement that declares this name; empty if none does.
  std::string text_of(std::string_view name) const;
  /// The differences between two versions, statement by statement: lines that begin with "- " and "+ ".
  std::string diff(std::size_t from, std::size_t to) const;
  bool is_empty() const;
  /// What relative includes are resolved against.
  std::string folder() const;
  bool includes_files() const;

  /// The scene that the document describes, with the defaults that were assumed. Valid until the next change. Its
  /// tables (shapes, materials, …) also contain what is no longer used: they only grow.
  const scene::Scene& scene();
  /// Its objects cut into ranges, none of which is very short; those whose content is unchanged have the same stamp.
  /// Only a few objects are in none of them.
  std::vector<SceneRange> ranges();
  /// The notes about the defaults assumed for it.
  const std::vector<Diagnostic>& assumptions();
  std::vector<ListedObject> objects();

  /// The names that the document binds or defines, sorted.
  std::vector<std::string> names() const;
  /// What the thing with this number is a copy of: "sphere", "table"; empty if none, or not a plain copy.
  std::string model_of(std::string_view number) const;
  /// The properties that a thing of this name (or number) takes: a noun's, a def's parameters, those of what the name
  /// is bound to.
  std::vector<std::string> properties_of(std::string_view name) const;
  /// The noun of that name or number, or of the thing that the name is bound to; null if there is none.
  const NodeType* noun_of(std::string_view name) const;
  /// The def of that name or number, or the one that made the thing; null if there is none.
  const FunctionInfo* def_of(std::string_view name) const;
  /// All that was parsed and resolved.
  const Program& program() const;
  /// Of all inputs; diagnostics point into it.
  const SourceMap& sources() const;
  const SessionCounters& counters() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace rt::lang
