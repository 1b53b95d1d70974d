#include "tools/povray/run/shots.hpp"

#include "renderer/scene/names.hpp"

#include <cassert>

namespace rt::tools::povray {
namespace {

using namespace rt::scene;

// The mean of each n × n square of pixels.
std::vector<Rgb32> shrink(const std::vector<Rgb32>& large, int width, int height, int n) {
  if (n == 1) return large;
  std::vector<Rgb32> small;
  small.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Color sum;
      for (int j = 0; j < n * n; ++j) {
        const int column = x * n + j % n, row = y * n + j / n;
        const Rgb32& p = large[static_cast<std::size_t>(row) * static_cast<std::size_t>(width * n) +
                               static_cast<std::size_t>(column)];
        sum += {p.r, p.g, p.b};
      }
      sum = sum * (1.0 / (n * n));
      small.push_back({static_cast<float>(sum.r), static_cast<float>(sum.g), static_cast<float>(sum.b)});
    }
  return small;
}

class Names {
public:
  explicit Names(const Scene& scene) : scene_(scene) { walk(scene.objects, no_name); }
  std::vector<ObjectName> take() { return std::move(names_); }

private:
  void walk(const std::vector<Object>& objects, NameId around) {
    for (const Object& o : objects) {
      if (!o.is_visible) continue;
      const NameId name = o.name == no_name ? around : o.name;
      if (o.shape.kind == kind_of<Group>)
        walk(scene_.shapes.get<Group>(o.shape).members, name);
      else
        names_.push_back(
            {std::string(name == no_name ? noun(scene_.shapes, o.shape) : scene::name(scene_, name)), o.origin});
    }
  }

  const Scene& scene_;
  std::vector<ObjectName> names_;
};

} // namespace

Shots shoot(const Scene& scene, const ShootOptions& options) {
  const int n = scene::sample_grid(scene::whitted_samples(scene)).value();
  Shots shots{scene.size[0], scene.size[1], {}, {}, {}, {}, true};
  run_many(4, options.at_once, [&](std::size_t i) {
    const Pass pass = static_cast<Pass>(i);
    const int scale = pass == Pass::color ? n : 1;
    Picture picture = render(export_povray(scene, {.pass = pass, .comments = false, .follows_every_ray = true}).text,
                             shots.width * scale, shots.height * scale, options.run);
    switch (pass) {
    case Pass::color:
      shots.color = shrink(picture.color, shots.width, shots.height, n);
      shots.is_float = picture.is_float;
      break;
    case Pass::ids:
      for (const Packed& p : picture.packed) shots.ids.push_back(decode_id(p));
      break;
    case Pass::depth:
      for (const Packed& p : picture.packed) shots.depth.push_back(decode_depth(p));
      break;
    case Pass::normals:
      for (const Rgb32& p : picture.color) shots.normal.push_back({p.r, p.g, p.b});
      break;
    }
  });
  return shots;
}

std::vector<ObjectName> object_names(const Scene& scene) {
  return Names(scene).take();
}

} // namespace rt::tools::povray
