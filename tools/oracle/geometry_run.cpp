#include "renderer/render/ray_query.hpp"
#include "tools/oracle/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <stdexcept>

namespace rt::tools::oracle {
namespace {

constexpr double povray_nearest = 1e-4, povray_farthest = 1e7, near_by = 1e-9;
constexpr std::size_t scenes_in_a_run = 100;

struct Answer {
  bool is_hit = false;
  double t = 0;
  Vec3 normal; // unit, against the ray
};

Vec3 against(const Vec3& normal, const Vec3& direction) {
  const Vec3 n = normalize(normal);
  return dot(n, direction) > 0 ? -n : n;
}

// From outside towards the centre, or from somewhere inside.
std::vector<Ray> random_rays(std::uint64_t seed, int count) {
  Dice scene(seed), dice(seed ^ 0x5261797321);
  dice.length_unit = random_length_unit(scene);
  const auto outside = [&dice] {
    const double away = dice.length(5, 9);
    return dice.direction() * away;
  };
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const Vec3 origin = dice.chance(0.15) ? dice.point(-2, 2) : outside();
    rays.push_back({origin, normalize(dice.point(-2, 2) - origin)});
  }
  return rays;
}

std::string numbers(const Ray& ray) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  return fmt::format("{}, {}, {}, {}, {}, {},\n", o.x, o.y, o.z, d.x, d.y, d.z);
}

// A scene file that traces rays from a file through one thing after another.
class Script {
public:
  void ask(const std::string& geometry, const std::vector<Ray>& rays) {
    text_ += geometry + fmt::format("Ask({})\n", rays.size());
    for (const Ray& ray : rays) rays_ += numbers(ray);
  }

  std::vector<Answer> run(const std::vector<Ray>& rays, const povray::RunOptions& options) const {
    const std::string output = povray::run_script(
        "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\ncamera { location 0 direction z }\n"
        "#declare N = <0, 0, 0>;\n#declare U = sphere { 0, 1 }\n#fopen RAYS \"rays\" read\n#fopen OUT \"hits\" write\n"
        "#macro Ask(Count)\n  #local K = 0;\n  #while (K < Count)\n    #local K = K + 1;\n"
        "    #read (RAYS, A1, A2, A3, B1, B2, B3)\n    #declare P = trace(U, <A1, A2, A3>, <B1, B2, B3>, N);\n"
        "    #write (OUT, vstr(3, P, \" \", 0, 17), \" \", vstr(3, N, \" \", 0, 17), \"\\n\")\n  #end\n#end\n" +
            text_ + "#fclose RAYS\n#fclose OUT\n",
        {{"rays", rays_}}, "hits", options);
    return read(output, rays);
  }

private:
  static std::vector<Answer> read(const std::string& output, const std::vector<Ray>& rays) {
    std::vector<Answer> answers;
    const char* at = output.c_str();
    const auto number = [&] {
      char* end = nullptr;
      const double value = std::strtod(at, &end);
      if (end == at) throw povray::Failed("POV-Ray wrote fewer hits than rays were asked");
      at = end;
      return value;
    };
    for (const Ray& ray : rays) {
      Vec3 p, n;
      p.x = number(), p.y = number(), p.z = number(), n.x = number(), n.y = number(), n.z = number();
      if (n == Vec3{})
        answers.push_back({});
      else
        answers.push_back({true, dot(p - ray.origin, ray.direction), against(n, ray.direction)});
    }
    return answers;
  }

  std::string text_, rays_;
};

Answer ask(const RayQuery& query, const Ray& ray) {
  const auto hit = query.nearest(ray, {povray_nearest, povray_farthest});
  if (!hit) return {};
  return {true, hit->t, against(hit->shading_normal, ray.direction)};
}

double relative(const Answer& ours, const Answer& theirs) {
  return std::abs(ours.t - theirs.t) / theirs.t;
}

// Whether a ray 1e-9 beside this one finds what POV-Ray finds: the ray grazes something.
bool is_at_an_edge(const RayQuery& query, const Ray& ray, const Answer& theirs) {
  const Vec3 least = std::abs(ray.direction.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalize(cross(ray.direction, least)), v = cross(ray.direction, u);
  for (int i = 0; i < 8; ++i) {
    const double angle = i * (std::numbers::pi / 4);
    const Answer other =
        ask(query, {ray.origin, normalize(ray.direction + (u * std::cos(angle) + v * std::sin(angle)) * near_by)});
    if (other.is_hit == theirs.is_hit && (!other.is_hit || relative(other, theirs) < 1e-6)) return true;
  }
  return false;
}

class GeometryRun {
public:
  explicit GeometryRun(const RunSettings& settings) : settings_(settings) {}

  RunResult run() {
    const std::size_t runs = (settings_.scenes + scenes_in_a_run - 1) / scenes_in_a_run;
    povray::run_many(runs, settings_.at_once, [&](std::size_t i) {
      const std::size_t begin = i * scenes_in_a_run;
      batch(settings_.first + begin, std::min(scenes_in_a_run, settings_.scenes - begin));
    });
    finish(result_, settings_, [this](Failure& failure) { make_small(failure); });
    return std::move(result_);
  }

private:
  Block file(std::size_t number) const { return random_file(settings_, number, Mode::geometry); }
  std::vector<Ray> rays(std::size_t number) const {
    return random_rays(scene_seed(settings_.seed, number), settings_.rays);
  }

  void batch(std::size_t first, std::size_t count) {
    if (settings_.stop && *settings_.stop) return;
    Script script;
    std::vector<std::optional<scene::Scene>> scenes(count);
    std::vector<Ray> all;
    for (std::size_t i = 0; i < count; ++i) {
      const Block block = file(first + i);
      try {
        scenes[i] = load(print(block));
        if (auto why = refusal(*scenes[i])) {
          scenes[i].reset();
          const std::lock_guard lock(mutex_);
          result_.refusals.push_back({first + i, std::move(*why)});
          continue;
        }
      } catch (const std::exception& error) {
        const std::lock_guard lock(mutex_);
        result_.failures.push_back({first + i, error.what(), print(block)});
        continue;
      }
      const std::vector<Ray> own = rays(first + i);
      script.ask(geometry_of(*scenes[i]), own);
      all.insert(all.end(), own.begin(), own.end());
    }
    const std::vector<Answer> answers = script.run(all, options());
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!scenes[i]) continue;
      RunResult one;
      const std::span<const Answer> own(answers.data() + at, static_cast<std::size_t>(settings_.rays));
      const std::string what = compare(*scenes[i], rays(first + i), own, one);
      at += own.size();
      const std::lock_guard lock(mutex_);
      result_.samples += one.samples;
      result_.add_geometry(one, features_of(*scenes[i]));
      if (!what.empty()) result_.failures.push_back({first + i, what, print(file(first + i))});
      if (settings_.on_progress) settings_.on_progress(result_.scenes);
    }
  }

  static std::string geometry_of(const scene::Scene& scene) {
    const std::string text = povray::export_geometry(scene, "U");
    return text.empty() ? "#declare U = sphere { 1e6, 1 }\n" : text;
  }

  povray::RunOptions options() const {
    povray::RunOptions run;
    run.stop = settings_.stop;
    return run;
  }

  static std::string compare(const scene::Scene& scene, const std::vector<Ray>& rays, std::span<const Answer> answers,
                             RunResult& r) {
    const RayQuery query(scene, 1);
    const povray::Gates gates;
    std::string what;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Answer ours = ask(query, rays[i]), &theirs = answers[i];
      ++r.samples;
      const bool is_same = ours.is_hit == theirs.is_hit;
      if (is_same && !ours.is_hit) continue;
      const double distance = is_same ? relative(ours, theirs) : 0;
      const double turn =
          is_same ? std::atan2(length(cross(ours.normal, theirs.normal)), dot(ours.normal, theirs.normal)) : 0;
      if (is_same && distance <= gates.depth && turn <= gates.normals) {
        ++r.depths;
        r.depths_beyond_p999 += distance > gates.depth_p999;
        r.depth_max = std::max(r.depth_max, distance);
        r.normal_max = std::max(r.normal_max, turn);
        continue;
      }
      ++r.id_mismatches;
      if (is_at_an_edge(query, rays[i], theirs)) continue;
      ++r.ids_unexplained;
      what = is_same ? fmt::format("ray {}: distance {:.3g}, normal {:.3g}", i, distance, turn)
                     : fmt::format("ray {}: {} for us, {} for POV-Ray", i, ours.is_hit ? "a hit" : "a miss",
                                   theirs.is_hit ? "a hit" : "a miss");
    }
    return what;
  }

  void make_small(Failure& failure) {
    const std::vector<Ray> own = rays(failure.scene);
    minimise(failure, file(failure.scene), [&](const scene::Scene& scene) {
      Script script;
      script.ask(geometry_of(scene), own);
      RunResult ignored;
      return !compare(scene, own, script.run(own, options()), ignored).empty();
    });
  }

  const RunSettings& settings_;
  std::mutex mutex_;
  RunResult result_;
};

} // namespace

RunResult run_geometry(const RunSettings& settings) {
  return GeometryRun(settings).run();
}

} // namespace rt::tools::oracle
