#include "lang/builtins/builtins.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace rt::lang {
namespace {

/// Whether the arguments are integers that name a pixel of the picture.
bool is_pixel(BuiltinCall& c) {
  const scene::Resolution size = c.scene().size;
  for (std::size_t i = 0; i < 2; ++i) {
    const double n = c.number(i);
    if (n != std::trunc(n))
      return c.fail(i, "pixel coordinates are integers; for a point between pixel centres use `image_point(x, y)`", ""),
             false;
    if (!(n >= 0 && n < size[i]))
      return c.fail(i, fmt::format("there is no such pixel: the picture has {} × {}, counted from 0", size[0], size[1]),
                    ""),
             false;
  }
  return true;
}

Value as_value(BuiltinCall& c, const Ray& ray) {
  std::vector<Value> parts{ray.origin, ray.direction};
  if (c.has(2)) parts.push_back(c[2]);
  return make_list(c.heap(), std::move(parts));
}

std::optional<Ray> pixel_ray(BuiltinCall& c) {
  if (!is_pixel(c)) return std::nullopt;
  const Observer* observer = c.observer();
  if (!observer) return std::nullopt;
  return observer->image_ray(c.number(0) + 0.5, c.number(1) + 0.5);
}

std::optional<Sighting> pixel_sighting(BuiltinCall& c, bool& is_asked) {
  const auto ray = pixel_ray(c);
  is_asked = ray.has_value();
  return ray ? c.observer()->nearest(*ray) : std::nullopt;
}

bool is_ray(BuiltinCall& c) {
  if (length(c.vector(1)) > 0 && is_finite(c.vector(0)) && is_finite(c.vector(1))) return true;
  c.fail(1, "a ray's direction must be finite and not zero", "");
  return false;
}

Value pixel(BuiltinCall& c) {
  const auto ray = pixel_ray(c);
  return ray ? as_value(c, *ray) : Value::poison();
}

Value image_point(BuiltinCall& c) {
  const scene::Resolution size = c.scene().size;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!(c.number(i) >= 0 && c.number(i) <= size[i]))
      return c.fail(i, fmt::format("this point is outside the picture of {} × {} pixels", size[0], size[1]), "");
  }
  const Observer* observer = c.observer();
  return observer ? as_value(c, observer->image_ray(c.number(0), c.number(1))) : Value::poison();
}

Value ray(BuiltinCall& c) {
  return is_ray(c) ? as_value(c, {c.vector(0), c.vector(1)}) : Value::poison();
}

Value depth(BuiltinCall& c) {
  bool is_asked = false;
  const auto seen = pixel_sighting(c, is_asked);
  if (!is_asked) return Value::poison();
  return seen ? seen->distance : std::numeric_limits<double>::infinity();
}

Value normal(BuiltinCall& c) {
  bool is_asked = false;
  const auto seen = pixel_sighting(c, is_asked);
  if (!is_asked) return Value::poison();
  return seen ? Value(seen->normal) : Value();
}

/// The light returned by `ask(observer, precision)`; grey becomes a number, for comparison.
template <class Ask>
Value light(BuiltinCall& c, Ask&& ask) {
  const Observer* observer = c.observer();
  if (!observer) return Value::poison();
  const std::optional<double> precision = c.precision();
  if (observer->estimates() && !precision)
    return c.fail(0, "in path mode this is an estimate: specify its precision, as in `~ 0.5 within 0.001`");
  const LightAnswer found = ask(*observer, precision.value_or(0));
  if (found.is_precise) return found.color;
  return c.fail(0,
                fmt::format("{} samples leave an error of {:.2g}, which must be a quarter of `within`: allow more, or "
                            "ask where there is less noise",
                            found.samples, found.error));
}

Value color(BuiltinCall& c) {
  if (!is_pixel(c)) return Value::poison();
  return light(c, [&](const Observer& observer, double precision) {
    return observer.pixel_color(static_cast<int>(c.number(0)), static_cast<int>(c.number(1)), precision);
  });
}

Value radiance(BuiltinCall& c) {
  if (!is_ray(c)) return Value::poison();
  return light(c, [&](const Observer& observer, double precision) {
    return observer.radiance({c.vector(0), c.vector(1)}, precision);
  });
}

Value irradiance(BuiltinCall& c) {
  if (!c.scene().is_path()) return c.fail(0, "irradiance requires `mode: path`");
  if (!(length(c.vector(1)) > 0) || !is_finite(c.vector(0)) || !is_finite(c.vector(1)))
    return c.fail(1, "a normal must be finite and not zero", "");
  return light(c, [&](const Observer& observer, double precision) {
    return observer.irradiance(c.vector(0), c.vector(1), precision);
  });
}

Value crossings(BuiltinCall& c) {
  const Observer* observer = is_ray(c) ? c.observer(2) : nullptr;
  if (!observer) return Value::poison();
  const std::vector<double> t = observer->crossings({c.vector(0), c.vector(1)});
  c.spend(t.size(), t.size() * sizeof(Value));
  return make_list(c.heap(), std::vector<Value>(t.begin(), t.end()));
}

} // namespace

std::span<const Builtin> questions() {
  static constexpr Builtin table[] = {
      {"pixel", "x: number, y: number", "the ray through the centre of a pixel; (0, 0) is top left", pixel},
      {"image_point", "x: number, y: number",
       "the ray through a point of the picture; pixel (0, 0) has its centre at (0.5, 0.5)", image_point},
      {"ray", "origin: vector, direction: vector, thing: any = ?",
       "any ray through the scene, or against one thing alone, placed or not", ray},
      {"depth", "x: number, y: number",
       "the distance from the eye to the hit of the ray through the pixel's centre; infinite for a miss", depth},
      {"normal", "x: number, y: number", "the unit normal there, pointing out of the solid; `none` for a miss", normal},
      {"color", "x: number, y: number", "the light of a pixel, as a colour before it is rounded", color},
      {"radiance", "origin: vector, direction: vector", "the radiance along a ray, as a colour", radiance},
      {"irradiance", "point: vector, normal: vector",
       "in path mode, the irradiance at a point on the side of the normal, as a colour; π under a white sky",
       irradiance},
      {"crossings", "origin: vector, direction: vector, thing: any = ?", "t of all hits of a ray, in order", crossings},
  };
  return table;
}

std::optional<std::size_t> find_question(std::string_view name) {
  const auto all = questions();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return i;
  }
  return std::nullopt;
}

} // namespace rt::lang
