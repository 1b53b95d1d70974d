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

/// The value of an expression that was typed by itself.
struct PrintedValue {
  std::string text;
  std::optional<Color> color; ///< of a colour, to be shown beside its text
};

/// What became of one input. Unless it is accepted the session is as it was before.
struct SessionResult {
  bool is_accepted = false;
  std::string problem;                 ///< a sentence, where something other than a statement's text is wrong
  std::vector<std::string> advice;     ///< what to know about the problem
  std::vector<Diagnostic> diagnostics; ///< errors where it is not accepted; else warnings and notes
  std::vector<std::string> changes;    ///< what happened to the document, a sentence each
  std::vector<PrintedValue> values;
  std::vector<Diagnostic> printed; ///< by `print`, in order: notes
};

/// A thing of the scene as `:list` shows it.
struct ListedObject {
  std::string name; ///< its `name`, or the name it is bound to; else empty
  std::string kind; ///< "sphere", "table"
  std::string place;
  std::uint64_t count = 1; ///< how many such things the same statement placed in a row
  /// The numbers that `set` and `remove` take for a name where there is none: one, but for things that were written so
  /// much alike that they are kept together. 0: it has a name.
  std::uint64_t first_number = 0, last_number = 0;
};

/// Objects of the scene that follow one another, with a number that stands for what they are.
struct SceneRange {
  std::uint32_t begin = 0, end = 0;
  std::uint64_t stamp = 0;
};

/// How much work was done since the session began: what an unchanged statement costs is 0.
struct SessionCounters {
  std::uint64_t statements_parsed = 0;
  std::uint64_t statements_evaluated = 0;
  std::uint64_t objects_evaluated = 0;
};

/// A state the document was in.
struct SessionVersion {
  std::string description; ///< what led to it: "sphere { radius: 2 }", ":remove ball"
  std::size_t parent = 0;  ///< the version it was made from; of the first one itself
};

/// A scene built statement by statement. What is submitted is the document: each accepted input joins it, is evaluated
/// once, and again only when a name it uses has changed. Errors change nothing. Every state the document was in is kept
/// and can be had again.
class Session {
public:
  /// Relative includes start from `folder`.
  explicit Session(std::string folder, LoadOptions options = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// One or more statements or expressions, as typed.
  SessionResult submit(std::string_view text);
  /// The document becomes that of a file. Throws what `load_file` throws.
  SessionResult load(const std::string& path);
  /// Writes a property into the statement that binds or places the thing with this name: `target` is "NAME.property",
  /// or "NUMBER.property" with a number of `objects()`.
  SessionResult set(std::string_view target, std::string_view value);
  /// Takes a binding, a definition or a placed thing out, by name or number, unless others use it.
  SessionResult remove(std::string_view name);
  SessionResult reset();

  bool undo();
  bool redo();
  /// Back (or forward) to a version.
  bool go_to(std::size_t version);
  std::size_t version() const;
  const std::vector<SessionVersion>& versions() const;

  /// The document's text at a version, as it was typed.
  std::string text() const { return text(version()); }
  std::string text(std::size_t version) const;
  /// As a scene file, in the formatter's layout.
  std::string formatted() const;
  /// The statement that declares this name; empty where none does.
  std::string text_of(std::string_view name) const;
  /// What differs between two versions, statement by statement: lines that begin with "- " and "+ ".
  std::string diff(std::size_t from, std::size_t to) const;
  bool is_empty() const;
  /// What relative includes start from.
  std::string folder() const;
  bool includes_files() const;

  /// The scene that the document says, with the defaults that were assumed. Stays valid until the next change. Its
  /// tables (shapes, materials, …) also hold what stands nowhere any more: they only grow.
  const scene::Scene& scene();
  /// Its objects cut into stretches, none of which is very short; those that hold what they held before have the same
  /// stamp. What is in none of them are few objects.
  std::vector<SceneRange> ranges();
  /// The notes on what was assumed for it.
  const std::vector<Diagnostic>& assumptions();
  std::vector<ListedObject> objects();

  /// The names that the document binds or defines, sorted.
  std::vector<std::string> names() const;
  /// What the thing with this number is a copy of: "sphere", "table"; empty where none has it, or it is no plain copy.
  std::string model_of(std::string_view number) const;
  /// The properties that a thing of this name (or number) takes: a noun's, a def's parameters, those of what the name
  /// is bound to.
  std::vector<std::string> properties_of(std::string_view name) const;
  /// The noun of that name or number, or of the thing that the name is bound to; null where there is none.
  const NodeType* noun_of(std::string_view name) const;
  /// The def of that name or number, or that the thing comes from; null where there is none.
  const FunctionInfo* def_of(std::string_view name) const;
  /// All that was read and resolved.
  const Program& program() const;
  /// Of what was submitted; diagnostics point into it.
  const SourceMap& sources() const;
  const SessionCounters& counters() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace rt::lang
