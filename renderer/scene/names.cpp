#include "renderer/scene/names.hpp"

namespace rt::scene {

std::string_view name(const Scene& scene, NameId id) {
  return id == no_name ? std::string_view() : std::string_view(scene.names[static_cast<std::size_t>(id)]);
}

std::string_view noun(const Shapes& shapes, ShapeRef shape) {
  return shapes.visit(shape, []<class S>(const S&) -> std::string_view { return S::noun; });
}

std::string_view noun(Combination::Operation operation) {
  switch (operation) {
  case Combination::Operation::unite:
    return "union";
  case Combination::Operation::intersect:
    return "intersection";
  case Combination::Operation::subtract:
    return "difference";
  }
  return "";
}

std::string_view noun(const LightSource& light) {
  return std::visit([]<class L>(const L&) -> std::string_view { return L::noun; }, light);
}

std::string_view noun(const PatternLayout& pattern) {
  return std::visit([]<class P>(const P&) -> std::string_view { return P::noun; }, pattern);
}

std::string_view noun(const Step& step) {
  return std::visit([]<class S>(const S&) -> std::string_view { return S::noun; }, step);
}

std::string_view name(Fade::Law law) {
  switch (law) {
  case Fade::Law::none:
    return "none";
  case Fade::Law::linear:
    return "linear";
  case Fade::Law::quadratic:
    return "quadratic";
  case Fade::Law::inverse_square:
    return "inverse_square";
  }
  return "";
}

} // namespace rt::scene
