#include "renderer/integrators/integrator.hpp"

#include "renderer/integrators/occlusion.hpp"
#include "renderer/integrators/path/path.hpp"
#include "renderer/integrators/whitted.hpp"

#include <cassert>

namespace rt {

std::unique_ptr<const Integrator> make_integrator(IntegratorKind kind, const CompiledScene& scene) {
  switch (kind) {
  case IntegratorKind::whitted:
    return make_whitted(scene);
  case IntegratorKind::whitted_exported:
    return make_whitted_exported(scene);
  case IntegratorKind::path:
    return make_path(scene);
  case IntegratorKind::occlusion:
    return make_occlusion(scene);
  case IntegratorKind::whitted_povray:
    return make_whitted_povray(scene);
  }
  assert(false);
  return nullptr;
}

} // namespace rt
