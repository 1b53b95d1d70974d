#include "renderer/render/render.hpp"
#include "tools/oracle/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

namespace rt::tools::oracle {
namespace {

std::string complaint(const povray::Comparison& c, const povray::Gates& gates) {
  std::string text;
  const auto add = [&](bool fails, const std::string& what) {
    if (fails) text += (text.empty() ? "" : "; ") + what;
  };
  add(c.ids_unexplained > 0, fmt::format("{} pixels with another object", c.ids_unexplained));
  add(c.depth_max > gates.depth, fmt::format("distance {:.3g}", c.depth_max));
  add(c.normal_max > gates.normals, fmt::format("normal {:.3g}", c.normal_max));
  add(c.color_unexplained > 0,
      fmt::format("{} pixels with another colour, by up to {:.3g}", c.color_unexplained, c.color_max));
  return text;
}

class ColorRun {
public:
  explicit ColorRun(const RunSettings& settings) : settings_(settings) {}

  RunResult run() {
    povray::run_many(settings_.scenes, settings_.at_once, [&](std::size_t i) { one(settings_.first + i); });
    finish(result_, settings_, [this](Failure& failure) { make_small(failure); });
    return std::move(result_);
  }

private:
  Block file(std::size_t number) const { return random_file(settings_, number, Mode::color); }

  void one(std::size_t number) {
    if (settings_.stop && *settings_.stop) return;
    const Block block = file(number);
    std::string what;
    povray::Comparison c;
    std::vector<std::size_t> features;
    try {
      scene::Scene scene = load(print(block));
      scene.size = {settings_.width, settings_.height};
      if (auto why = refusal(scene)) {
        const std::lock_guard lock(mutex_);
        result_.refusals.push_back({number, std::move(*why)});
        return;
      }
      features = features_of(scene);
      c = compare(scene, 1);
      what = complaint(c, {});
    } catch (const povray::Missing&) {
      throw;
    } catch (const std::exception& error) {
      what = error.what();
    }
    const std::lock_guard lock(mutex_);
    add(c, features);
    for (const povray::Outlier& o : c.outliers)
      if (o.is_traced_again && povray::is_explained(o.cause)) result_.explained.push_back({number, o});
    if (!what.empty()) result_.failures.push_back({number, what, print(block)});
    if (settings_.on_progress) settings_.on_progress(result_.scenes);
  }

  povray::Comparison compare(scene::Scene& scene, int at_once) const {
    scene.size = {settings_.width, settings_.height};
    RenderOptions options;
    options.threads = 1;
    options.layers = true;
    options.integrator = IntegratorKind::whitted_exported;
    const Film film = render(scene, options).film;
    povray::ShootOptions shoot;
    shoot.at_once = at_once;
    shoot.run.stop = settings_.stop;
    return povray::compare(scene, film, povray::shoot(scene, shoot));
  }

  void add(const povray::Comparison& c, const std::vector<std::size_t>& features) {
    result_.samples += c.pixels;
    result_.add_geometry(c, features);
    result_.color_equal += c.color_equal;
    result_.color_unexplained += c.color_unexplained;
    result_.color_explained_by_rounding += c.color_unstable;
    result_.color_explained_by_limits += c.pixels - c.color_equal - c.color_unexplained - c.color_unstable;
    if (c.color_unexplained > 0) result_.color_max = std::max(result_.color_max, c.color_max);
  }

  void make_small(Failure& failure) {
    minimise(failure, file(failure.scene),
             [&](scene::Scene& scene) { return !complaint(compare(scene, 4), {}).empty(); });
  }

  const RunSettings& settings_;
  std::mutex mutex_;
  RunResult result_;
};

} // namespace

RunResult run_colors(const RunSettings& settings) {
  return ColorRun(settings).run();
}

} // namespace rt::tools::oracle
