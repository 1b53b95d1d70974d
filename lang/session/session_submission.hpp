#pragma once

#include "lang/session/session_change.hpp"

#include <cstdint>
#include <string_view>

namespace rt::lang {

/// One input on its way into the document.
class Submission {
public:
  /// `last_id`: of the statement that a line beginning with `.` edits.
  Submission(SessionCore& core, SessionChange& change, std::uint64_t last_id)
      : core_(core), change_(change), last_id_(last_id) {}

  /// Errors in the text are in the report.
  void run(std::string_view text);
  /// The id of the statement that a line beginning with `.` edits next.
  std::uint64_t last_id() const { return last_id_; }

private:
  void take(const SessionChange::Draft& draft);
  void edit(const SessionChange::Draft& draft, NodeId item);
  SessionChange::Draft without_itself(const SessionChange::Draft& draft);

  SessionCore& core_;
  SessionChange& change_;
  std::uint64_t last_id_;
};

} // namespace rt::lang
