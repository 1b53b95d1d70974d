#pragma once

#include "tools/bench/bars/rays.hpp"
#include "tools/bench/scenes/layout.hpp"

#include <cstddef>

namespace rt::tools::bench {

/// CPU seconds for the rays of a frame: intersection only.
struct TracingCost {
  double seconds = 0;
  std::size_t hits = 0; ///< nearest hits found, and shadow rays blocked
};

/// With our trees, in double precision.
TracingCost trace_exactly(const CompiledScene& scene, const FrameRays& rays);

/// With Embree's own primitives in single precision: sphere points, cone curves for tubes, triangles.
TracingCost trace_natively(const Layout& layout, const FrameRays& rays);

/// CPU time of this process so far.
double cpu_seconds();

} // namespace rt::tools::bench
