#pragma once

#include "lang/session/session.hpp"
#include "lang/session/session_document.hpp"

#include <vector>

namespace rt::lang {

/// The scene of a session's document, kept up to date: what precedes the first change is not touched.
class SessionScene {
public:
  /// `evaluator` owns the scene with its tables.
  SessionScene(Evaluator& evaluator, const Program& program) : evaluator_(evaluator), program_(program) {}

  void show(const Document& document);
  const scene::Scene& scene() const { return evaluator_.scene(); }
  const std::vector<Diagnostic>& assumptions() const { return assumptions_; }
  std::vector<SceneRange> ranges() const;

private:
  // A statement with objects, and where they are in the scene.
  struct Placed {
    std::uint64_t stamp;
    std::uint32_t begin, end;
  };

  void show_settings(const Document& document);
  void assume(const Document& document, bool has_camera, bool has_ambient);

  Evaluator& evaluator_;
  const Program& program_;
  std::vector<Placed> placed_;
  std::vector<Diagnostic> assumptions_;
};

} // namespace rt::lang
