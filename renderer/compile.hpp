#pragma once

#include "renderer/assembly.hpp"

#include <memory>
#include <vector>

namespace rt {

/// A scene description turned into trees of leaves. Groups that stand in one place only are taken apart: their members'
/// transforms are multiplied out. A group of some size that stands in several becomes an assembly of its own, with an
/// instance for each place.
class Compiled {
public:
  /// `threads` to build with. The scene need not outlive what is compiled. Throws std::bad_alloc or std::runtime_error.
  Compiled(const scene::Scene& scene, int threads);

  const Assembly& root() const { return *assemblies_.back(); }
  const Styles& styles() const { return styles_; }

private:
  friend class Compiler;

  accel::Device device_;
  Styles styles_;
  std::vector<std::unique_ptr<Solid>> solids_;
  std::vector<std::unique_ptr<Assembly>> assemblies_; // every one after those it has instances of
};

} // namespace rt
