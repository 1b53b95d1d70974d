#pragma once

#include "lang/check/files.hpp"
#include "lang/session/session.hpp"
#include "lang/session/session_document.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rt::lang {

/// What all states of a session share. All of it only grows.
struct SessionCore {
  explicit SessionCore(std::string folder, LoadOptions load_options);

  LoadOptions options;
  Program program;
  Report report; ///< for the current input
  Files files;
  Evaluator evaluator;
  std::uint32_t slots = 0; ///< of the session's frame that are taken
  std::uint64_t last_id = 0, last_stamp = 0, inputs = 0;
  SessionCounters counters;
};

/// A change of a document in progress: statements are inserted, replaced and removed; then `finish` evaluates whatever
/// that requires. The original document is not modified.
class SessionChange {
public:
  using Draft = std::shared_ptr<Statement>;

  SessionChange(SessionCore& core, const Document& document);

  /// Parses statements; errors are in the report.
  std::vector<Draft> parse(std::string text, const TextOrigin& origin, bool is_typed);
  /// The text of a whole file, in which a statement may represent many things.
  std::vector<Draft> parse_file(std::string text, const TextOrigin& origin);
  /// A statement again, with a different text. Nothing if that is not a statement, which is reported.
  Draft parse_again(const Statement& old, std::string text);

  void append(Draft draft);
  /// Appends it, or replaces what declares the same name or sets the same property.
  void place(Draft draft);
  /// The same, and its outcome will be listed among the changes.
  void place_and_tell(Draft draft);
  void replace(std::size_t at, Draft draft);
  /// Splits a statement that represents many items into one for each; other statements are left alone.
  void split(std::size_t at);
  void erase(std::size_t at);
  void clear();

  std::size_t size() const { return entries_.size(); }
  const Statement& operator[](std::size_t i) const { return entries_[i].get(); }
  std::optional<std::size_t> find(Symbol name) const;
  std::optional<std::size_t> find_id(std::uint64_t id) const;
  /// The statements that use a name declared by this one.
  std::vector<std::size_t> users(std::size_t at) const;

  /// Checks and evaluates; returns the new document, unless there is an error in the report.
  std::optional<Document> finish();

  std::vector<std::string> changes;
  std::vector<PrintedValue> values;

private:
  struct RevisedStatement {
    const StatementRef* done = nullptr; // in the original document
    Draft fresh;                        // if set, `done` is out of date
    std::uint32_t chunk = 0;            // of that document
    std::uint8_t done_traits = 0;
    const Statement& get() const { return fresh ? *fresh : **done; }
    std::uint8_t traits() const { return fresh ? traits_of(*fresh) : done_traits; }
  };
  struct ChangedName {
    bool is_function;
    std::size_t position;
  };

  const Document::Chunk& chunk_of(const RevisedStatement& entry) const { return *old_.chunks()[entry.chunk]; }
  std::size_t place_in_chunk(const RevisedStatement& entry) const {
    return static_cast<std::size_t>(entry.done - chunk_of(entry).statements.data());
  }
  // Bloom filters of symbols: false positives are possible.
  std::uint64_t declared_bits(const RevisedStatement& entry) const;
  std::uint64_t used_bits(const RevisedStatement& entry) const;

  Draft make_draft(Unit& unit, NodeId node, const std::string& text, const TextOrigin& origin) const;
  Draft redraft(const Statement& old);
  Unit& add_unit(std::string text, const TextOrigin& origin, bool folds_repeats, bool is_typed);
  std::vector<Symbol> mentioned(const Statement& statement) const;
  void move_behind(std::size_t at, std::size_t needed, Draft draft);
  void mark_changed(const Statement& statement, std::size_t position);
  bool is_affected(const Statement& statement, std::size_t position) const;
  void renew_dependents();
  void report_outcomes();
  void report_dependents();
  bool check();
  struct Mentioned {
    std::vector<bool> symbols;
    std::uint64_t bits = 0;
  };
  std::optional<Mentioned> mentioned_by_fresh() const;
  bool evaluate();
  void take_out_printed();
  void settle_only(Trait which);
  void check_scene_properties();
  Document assemble();

  SessionCore& core_;
  Document old_;
  std::vector<RevisedStatement> entries_;
  std::unordered_map<std::uint32_t, ChangedName> changed_; // by symbol
  std::uint64_t changed_bits_ = 0;                         // its keys, as a Bloom filter
  // For the messages:
  struct Reported {
    std::uint64_t id; // of the statement
    bool replaces;    // another one
  };
  std::vector<Reported> reported_;
  std::vector<std::string> renewed_; // statements
};

} // namespace rt::lang
