#include "tools/explain/observer.hpp"

#include "renderer/render/ray_query.hpp"
#include "tools/explain/naming.hpp"

namespace rt::tools::explain {
namespace {

class TracingObserver final : public lang::Observer {
public:
  explicit TracingObserver(const scene::Scene& scene) : scene_(scene), query_(scene) {}

  Ray image_ray(double x, double y) const override { return query_.camera().ray(x, y); }

  std::optional<lang::Sighting> nearest(const Ray& ray) const override {
    const auto hit = query_.nearest(ray);
    if (!hit) return std::nullopt;
    lang::Sighting seen{hit->t, hit->distance, hit->geometric_normal, {}, Namer(scene_).title(hit->path)};
    for (const scene::Object* object : objects_on(scene_, hit->path)) seen.objects.push_back(*object);
    return seen;
  }

  std::vector<double> crossings(const Ray& ray) const override {
    std::vector<double> t;
    for (const HitReport& hit : query_.all_hits(ray)) t.push_back(hit.t);
    return t;
  }

  Color pixel_color(int x, int y) const override { return query_.pixel(x, y); }

private:
  const scene::Scene& scene_;
  RayQuery query_;
};

} // namespace

lang::ObserverMaker tracing_observer() {
  return [](const scene::Scene& scene) { return std::make_unique<TracingObserver>(scene); };
}

} // namespace rt::tools::explain
