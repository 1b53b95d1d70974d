#pragma once

#include "lang/session/session.hpp"
#include "lang/session/session_change.hpp"
#include "lang/session/session_scene.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rt::lang {

/// All versions of a session's document, and the scene of the current one.
struct Session::State {
  State(std::string folder, LoadOptions options)
      : core(std::move(folder), std::move(options)), scene(core.evaluator, core.program) {
    versions.push_back({"", 0});
    documents.push_back({std::make_shared<const Document>(), 0});
  }

  struct Kept {
    std::shared_ptr<const Document> document;
    std::uint64_t last_id = 0; ///< the statement that a line beginning with `.` edits
  };

  const Document& document() const { return *documents[current].document; }

  /// The outcome of a change: a new version unless there is an error, or nothing has changed.
  SessionResult finish(SessionChange& change, std::string description, std::uint64_t last_id) {
    SessionResult result;
    std::optional<Document> made = change.finish();
    result.diagnostics = core.report.diagnostics();
    result.printed = core.evaluator.take_printed();
    if (!made) {
      scene.show(document()); // evaluation may have left its own settings in it
      return result;
    }
    result.is_accepted = true;
    result.changes = std::move(change.changes);
    result.values = std::move(change.values);
    if (*made != document()) keep(std::make_shared<const Document>(std::move(*made)), std::move(description), last_id);
    scene.show(document());
    return result;
  }

  void keep(std::shared_ptr<const Document> made, std::string description, std::uint64_t last_id) {
    versions.push_back({std::move(description), current});
    documents.push_back({std::move(made), last_id});
    current = versions.size() - 1;
    undone.clear();
  }

  void go_to(std::size_t version) {
    current = version;
    scene.show(document());
  }

  /// The report on an input that is not accepted.
  SessionResult failed() const {
    SessionResult result;
    result.diagnostics = core.report.diagnostics();
    return result;
  }

  SessionCore core;
  SessionScene scene;
  std::vector<SessionVersion> versions;
  std::vector<Kept> documents;     // by version
  std::vector<std::size_t> undone; // versions to redo, the next one last
  std::size_t current = 0;
};

} // namespace rt::lang
