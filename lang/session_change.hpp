#pragma once

#include "lang/files.hpp"
#include "lang/session.hpp"
#include "lang/session_statement.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rt::lang {

/// What all states of a session share. Everything in it only grows.
struct SessionCore {
  explicit SessionCore(std::string folder, LoadOptions load_options);

  LoadOptions options;
  Program program;
  Report report; ///< of the input at hand
  Files files;
  Evaluator evaluator;
  std::uint32_t slots = 0; ///< of the session's frame that are taken
  std::uint64_t last_id = 0, last_stamp = 0, inputs = 0;
  SessionCounters counters;
};

/// A change of a document on its way: statements are put in, replaced and taken out; then `finish` evaluates what that
/// makes necessary. The document it began with stays as it is.
class SessionChange {
public:
  using Draft = std::shared_ptr<Statement>;

  SessionChange(SessionCore& core, const Document& document);

  /// Reads statements; what is wrong with them is in the report.
  std::vector<Draft> parse(std::string text, const TextOrigin& origin, bool is_typed);
  /// The text of a whole file, whose statements may stand for many things each.
  std::vector<Draft> parse_file(std::string text, const TextOrigin& origin);
  /// A statement again, with another text. Nothing where that is no statement, which is reported.
  Draft parse_again(const Statement& old, std::string text);

  void append(Draft draft);
  /// Appends it, or replaces what declares the same name or sets the same property.
  void place(Draft draft);
  void replace(std::size_t at, Draft draft);
  void erase(std::size_t at);
  void clear();

  std::size_t size() const { return entries_.size(); }
  const Statement& operator[](std::size_t i) const { return entries_[i].get(); }
  std::optional<std::size_t> find(Symbol name) const;
  std::optional<std::size_t> find_id(std::uint64_t id) const;
  /// The statements that use a name of this one.
  std::vector<std::size_t> users(std::size_t at) const;

  /// Checks and evaluates; the new document, unless there is an error in the report.
  std::optional<Document> finish();

  std::vector<std::string> changes;
  std::vector<PrintedValue> values;

private:
  struct Entry {
    StatementRef done;
    Draft fresh; // set: `done` is out of date
    const Statement& get() const { return fresh ? *fresh : *done; }
  };
  struct ChangedName {
    bool is_function;
    std::size_t position;
  };

  Draft make_draft(Unit& unit, NodeId node, const std::string& text, const TextOrigin& origin) const;
  Draft redraft(const Statement& old);
  Unit& add_unit(std::string text, const TextOrigin& origin, bool folds_repeats, bool is_typed);
  bool mentions(const Statement& statement, Symbol name) const;
  void move_behind(std::size_t at, std::size_t needed, Draft draft);
  void mark_changed(const Statement& statement, std::size_t position);
  bool is_affected(const Statement& statement, std::size_t position) const;
  void renew_dependents();
  void tell_dependents(const std::vector<std::string>& renewed);
  bool check();
  bool evaluate();
  void take_out_printed();
  void settle_cameras();
  void check_scene_properties();

  SessionCore& core_;
  std::vector<Entry> entries_;
  std::unordered_map<std::uint32_t, ChangedName> changed_; // by symbol
  std::vector<std::string> replaced_;                      // names, for the messages
};

} // namespace rt::lang
