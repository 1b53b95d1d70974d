#pragma once

#include "lang/load.hpp"
#include "tools/explain/why/why.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <utility>

/// Scenes as text, and what is explained of a ray through them.
namespace rt::tests {

namespace explain = tools::explain;
using json = nlohmann::ordered_json;

inline const explain::Detail whole{.all = true};

struct Explained {
  scene::Scene scene;
  RayQuery query;
  explain::Answer answer;

  Explained(scene::Scene described, const explain::Question& question)
      : scene(std::move(described)), query(scene, 1), answer(scene, "test.rtl", query, question) {}
};

inline std::unique_ptr<Explained> along(const std::string& text, const Vec3& origin, const Vec3& direction) {
  auto loaded = lang::load_text(text, "test.rtl", ".", {});
  REQUIRE(loaded.scene);
  explain::Question question;
  question.ray = Ray{origin, direction};
  return std::make_unique<Explained>(std::move(*loaded.scene), question);
}

inline json surface_of(const Explained& asked) {
  return explain::why_json(asked.answer, whole)["tree"]["surfaces"].at(0);
}
inline json derivation_of(const Explained& asked) {
  return surface_of(asked)["derivation"];
}
inline std::string sentence_of(const std::string& text, const Vec3& origin = {0, 0, 5},
                               const Vec3& direction = {0, 0, -1}) {
  return explain::verdict(along(text, origin, direction)->answer);
}
// With its lines joined.
inline std::string flowing(const std::string& text) {
  std::string joined;
  for (const char c : text) {
    const bool is_space = c == ' ' || c == '\n';
    if (!is_space || !joined.ends_with(' ')) joined += is_space ? ' ' : c;
  }
  return joined;
}
inline std::string text_of(const Explained& asked) {
  return flowing(explain::why_text(asked.answer, whole));
}
inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace rt::tests
