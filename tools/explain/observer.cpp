#include "tools/explain/observer.hpp"

#include "renderer/render/estimate.hpp"
#include "renderer/render/pixel_filter.hpp"
#include "renderer/render/ray_query.hpp"
#include "renderer/render/render.hpp"
#include "tools/explain/naming.hpp"

#include <optional>

namespace rt::tools::explain {
namespace {

class TracingObserver final : public lang::Observer {
public:
  explicit TracingObserver(const scene::Scene& scene) : scene_(scene), query_(scene) {}

  Ray image_ray(double x, double y) const override { return query_.camera().ray(x, y); }

  std::optional<lang::Sighting> nearest(const Ray& ray) const override {
    const auto hit = query_.nearest(ray);
    if (!hit) return std::nullopt;
    lang::Sighting seen{hit->t, hit->distance, hit->normal, {}, Namer(scene_).title(hit->path)};
    for (const scene::Object* object : objects_on(scene_, hit->path)) seen.objects.push_back(*object);
    return seen;
  }

  std::vector<double> crossings(const Ray& ray) const override {
    std::vector<double> t;
    for (const HitReport& hit : query_.all_hits(ray)) t.push_back(hit.t);
    return t;
  }

  bool estimates() const override { return scene_.is_random(); }

  lang::LightAnswer pixel_color(int x, int y, double precision) const override {
    if (!estimates()) return {query_.pixel(x, y)};
    const FilterSampler filter(view_of(scene_).filter);
    return answer(
        estimator().radiance(
            [&](const SampleStream& stream) { return sample_ray(query_.camera(), filter, stream, x, y); }, precision),
        precision);
  }

  lang::LightAnswer radiance(const Ray& ray, double precision) const override {
    if (!estimates()) return {query_.radiance(ray)};
    const Ray traced = RayQuery::unit(ray);
    return answer(estimator().radiance([&](const SampleStream&) { return traced; }, precision), precision);
  }

  lang::LightAnswer irradiance(const Vec3& point, const Vec3& normal, double precision) const override {
    return answer(estimator().irradiance(point, normalize(normal), precision), precision);
  }

private:
  const Estimator& estimator() const {
    if (!estimator_) estimator_.emplace(query_.scene(), scene_.is_path());
    return *estimator_;
  }

  static lang::LightAnswer answer(const Estimate& found, double precision) {
    return {found.mean, found.error, found.samples, Estimator::safety * found.error <= precision};
  }

  const scene::Scene& scene_;
  RayQuery query_;
  mutable std::optional<Estimator> estimator_; // created on first use
};

} // namespace

lang::ObserverMaker tracing_observer() {
  return [](const scene::Scene& scene) { return std::make_unique<TracingObserver>(scene); };
}

} // namespace rt::tools::explain
