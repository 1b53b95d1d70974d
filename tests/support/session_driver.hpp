#pragma once

#include "lang/session/session.hpp"
#include "renderer/render/render.hpp"

#include <catch2/catch.hpp>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// What the tests of sessions share.
namespace rt::tests {

// A session that is told what it should accept.
struct SessionDriver {
  lang::Session session{"."};

  lang::SessionResult say(const std::string& text) {
    lang::SessionResult result = session.submit(text);
    INFO(text);
    for (const lang::Diagnostic& d : result.diagnostics) UNSCOPED_INFO(lang::render(d, session.sources(), false));
    REQUIRE(result.is_accepted);
    return result;
  }
  std::string value(const std::string& text) {
    const lang::SessionResult result = say(text);
    REQUIRE(result.values.size() == 1);
    return result.values.front().text;
  }
  lang::SessionResult refuse(const std::string& text) {
    const std::size_t version = session.version();
    const std::string before = session.text();
    lang::SessionResult result = session.submit(text);
    INFO(text);
    CHECK_FALSE(result.is_accepted);
    CHECK_FALSE(result.diagnostics.empty());
    CHECK(session.version() == version);
    CHECK(session.text() == before);
    return result;
  }
  std::size_t count() { return session.scene().objects.size(); }
  Vec3 at(std::size_t i) { return scene::bounds(session.scene(), session.scene().objects.at(i)).center(); }
  double radius(std::size_t i) {
    return session.scene().shapes.get<scene::Sphere>(session.scene().objects.at(i).shape).radius;
  }
};

inline std::vector<Rgb32> picture(const scene::Scene& scene) {
  scene::Scene small = scene;
  small.size = {48, 36};
  return render(small, {}).film.color;
}

inline bool are_equal(const std::vector<Rgb32>& a, const std::vector<Rgb32>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Rgb32)) == 0;
}

struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("rtlang_session_test_" + std::to_string(getpid()));
  Folder() {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
    return (path / name).string();
  }
};

} // namespace rt::tests
