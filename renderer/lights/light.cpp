#include "renderer/lights/light.hpp"

namespace rt {

double fade_at(const scene::Fade& fade, double distance) {
  const double relative = distance / fade.distance;
  switch (fade.law) {
  case scene::Fade::Law::none:
    return 1;
  case scene::Fade::Law::linear:
    return 1 / (1 + relative);
  case scene::Fade::Law::quadratic:
    return 1 / (1 + relative * relative);
  case scene::Fade::Law::inverse_square:
    return 1 / (distance * distance);
  }
  return 1;
}

} // namespace rt
