#include "tools/povray/compare/compare.hpp"

#include "tools/povray/compare/retrace.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rt::tools::povray {
namespace {

Vec3 to_vec(const Xyz32& v) {
  return {v.x, v.y, v.z};
}

// The angle between two unit vectors; from the sine as well, because the cosine alone is inaccurate for small angles.
double angle(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

double relative(double ours, double theirs) {
  if (std::isinf(ours) || std::isinf(theirs)) return ours == theirs ? 0 : std::numeric_limits<double>::infinity();
  return std::abs(ours - theirs) / theirs;
}

// 16-bit files contain nothing outside [0, 1].
Rgb32 clamped(const Rgb32& c) {
  return {std::clamp(c.r, 0.0f, 1.0f), std::clamp(c.g, 0.0f, 1.0f), std::clamp(c.b, 0.0f, 1.0f)};
}

class Comparer {
public:
  Comparer(const scene::Scene& scene, const Film& film, const Shots& shots, const Gates& gates)
      : film_(film), shots_(shots), gates_(gates), retracer_(scene) {
    result_.width = film.width;
    result_.height = film.height;
    result_.pixels = film.color.size();
    result_.has_normals = shots.is_float;
    result_.color_error.resize(result_.pixels);
    result_.depth_error.resize(result_.pixels);
    result_.normal_error.resize(result_.pixels);
  }

  Comparison run() {
    for (int y = 0; y < film_.height; ++y)
      for (int x = 0; x < film_.width; ++x) pixel(x, y);
    if (!depths_.empty()) {
      const auto at = depths_.begin() + static_cast<std::ptrdiff_t>((depths_.size() - 1) * 999 / 1000);
      std::nth_element(depths_.begin(), at, depths_.end());
      result_.depth_p999 = *at;
    }
    result_.depths = depths_.size();
    std::stable_sort(result_.outliers.begin(), result_.outliers.end(), [](const Outlier& a, const Outlier& b) {
      return std::pair(is_explained(a.cause), -a.color_error) < std::pair(is_explained(b.cause), -b.color_error);
    });
    return std::move(result_);
  }

private:
  void pixel(int x, int y) {
    const std::size_t i = film_.index(x, y);
    Outlier o{.x = x,
              .y = y,
              .our_id = film_.object_id[i],
              .their_id = shots_.ids[i],
              .ours = film_.color[i],
              .theirs = shots_.color[i]};
    if (!shots_.is_float) o.ours = clamped(o.ours);
    const bool is_same = o.our_id == o.their_id;
    if (is_same && o.our_id != 0) geometry(i, o);
    o.color_error = color_difference(o.ours, o.theirs);
    const bool is_equal = o.color_error <= gates_.color;
    count_color(o, is_equal);
    result_.color_error[i] = static_cast<float>(o.color_error);
    result_.depth_error[i] = static_cast<float>(o.depth_error);
    result_.normal_error[i] = static_cast<float>(o.normal_error);
    const bool has_same_surface = is_same && o.depth_error <= gates_.depth && o.normal_error <= gates_.normals;
    if (!has_same_surface) explain_surface(i, o);
    if (has_same_surface || !is_explained(o.cause)) {
      result_.depth_max = std::max(result_.depth_max, o.depth_error);
      result_.normal_max = std::max(result_.normal_max, o.normal_error);
    }
    if (!is_equal) explain_color(o);
    if (!has_same_surface || !is_equal) result_.outliers.push_back(o);
  }

  void explain_surface(std::size_t i, Outlier& o) {
    const bool is_same = o.our_id == o.their_id;
    if (differs_by_rules(i, o))
      o.cause = Cause::tolerance;
    else if (is_same)
      o.cause = o.depth_error > gates_.depth ? Cause::depth : Cause::normal;
    else
      o.cause = edge_cause(o);
    if (is_same) return;
    ++result_.id_mismatches;
    result_.ids_unexplained += !is_explained(o.cause);
  }

  // Whether our rules lead to our object, distance and normal, and POV-Ray's to its own, with a difference no larger
  // than the rules explain.
  bool differs_by_rules(std::size_t i, const Outlier& o) {
    const CenterHit ours = retracer_.hit(o.x, o.y, HitRules::own);
    const CenterHit theirs = retracer_.hit(o.x, o.y, HitRules::povray);
    return is_shown(ours, o.our_id, film_.depth[i], film_.normal[i]) &&
           is_shown(theirs, o.their_id, shots_.depth[i], shots_.normal[i]) &&
           retracer_.is_within_reach(o.x, o.y, ours, theirs);
  }

  bool is_shown(const CenterHit& hit, std::uint32_t id, double depth, const Xyz32& normal) const {
    if (hit.id != id || hit.id == 0) return hit.id == id;
    return relative(hit.distance, depth) <= gates_.depth &&
           (!result_.has_normals || angle(hit.normal, to_vec(normal)) <= gates_.normals);
  }

  void explain_color(Outlier& o) {
    o.is_traced_again = true;
    o.again = retracer_.color(o.x, o.y);
    if (!shots_.is_float) o.again = clamped(o.again);
    const bool agrees = color_difference(o.again, o.theirs) <= gates_.color;
    const bool is_unstable = !agrees && shots_.is_float && retracer_.is_unstable(o.x, o.y, o.theirs, gates_.color);
    result_.color_unexplained += !agrees && !is_unstable;
    result_.color_unstable += is_unstable;
    if (o.cause == Cause::shading && (agrees || is_unstable)) o.cause = agrees ? Cause::tolerance : Cause::rounding;
    if (o.cause == Cause::tolerance && !agrees && !is_unstable) o.cause = Cause::shading;
  }

  void geometry(std::size_t i, Outlier& o) {
    o.depth_error = relative(film_.depth[i], shots_.depth[i]);
    depths_.push_back(o.depth_error);
    result_.depths_beyond_p999 += o.depth_error > gates_.depth_p999;
    if (result_.has_normals) o.normal_error = angle(to_vec(film_.normal[i]), to_vec(shots_.normal[i]));
  }

  void count_color(const Outlier& o, bool is_equal) {
    result_.color_equal += is_equal;
    result_.color_within_8bit += o.color_error <= 1.0 / 255;
    if (!(o.color_error > result_.color_max)) return;
    result_.color_max = o.color_error;
    result_.color_max_x = o.x;
    result_.color_max_y = o.y;
  }

  Cause edge_cause(const Outlier& o) {
    if (retracer_.is_hit_beside(o.x, o.y, o.their_id)) return Cause::tangency;
    if (retracer_.is_hit_behind(o.x, o.y, o.their_id)) return Cause::coincidence;
    return Cause::edge;
  }

  const Film& film_;
  const Shots& shots_;
  const Gates& gates_;
  Retracer retracer_;
  Comparison result_;
  std::vector<double> depths_;
};

// A fraction that allows one pixel even in a small picture.
double needed_share(const Comparison& c, double share) {
  const double allowed = std::max(1.0, std::floor((1 - share) * static_cast<double>(c.pixels)));
  return c.pixels == 0 ? 0 : 1 - allowed / static_cast<double>(c.pixels);
}

} // namespace

double color_difference(const Rgb32& a, const Rgb32& b) {
  const auto channel = [](double x, double y) {
    const double d = std::abs(x - y) / std::max({1.0, std::abs(x), std::abs(y)});
    return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
  };
  return std::max({channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)});
}

Comparison compare(const scene::Scene& scene, const Film& film, const Shots& shots, const Gates& gates) {
  assert(film.has_layers() && film.width == shots.width && film.height == shots.height);
  return Comparer(scene, film, shots, gates).run();
}

std::array<GateName, 7> gate_names() {
  return {{
      {"ids", &Gates::ids, "pixels with another object, unexplained"},
      {"depth", &Gates::depth, "distance, largest relative difference, unexplained"},
      {"depth_p999", &Gates::depth_p999, "distance, 99.9th percentile"},
      {"normals", &Gates::normals, "normals, largest angle (radians), unexplained"},
      {"color", &Gates::color, "colours that differ by less are equal"},
      {"color_share", &Gates::color_share, "fraction of pixels with equal colour"},
      {"color_unexplained", &Gates::color_unexplained, "pixels with another colour, unexplained"},
  }};
}

const char* cause_name(Cause cause) {
  switch (cause) {
  case Cause::edge:
    return "edge";
  case Cause::depth:
    return "depth";
  case Cause::normal:
    return "normal";
  case Cause::shading:
    return "shading";
  case Cause::tangency:
    return "tangency";
  case Cause::coincidence:
    return "coincidence";
  case Cause::tolerance:
    return "POV-Ray's tolerance";
  case Cause::rounding:
    return "rounding";
  }
  return "";
}

std::vector<Verdict> judge(const Comparison& c, const Gates& gates) {
  const double pixels = static_cast<double>(std::max<std::size_t>(c.pixels, 1));
  const double values[] = {static_cast<double>(c.ids_unexplained),
                           c.depth_max,
                           c.depth_p999,
                           c.normal_max,
                           0,
                           static_cast<double>(c.color_equal) / pixels,
                           static_cast<double>(c.color_unexplained)};
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; const GateName& gate : gate_names()) {
    Verdict v{gate.name, gate.meaning, values[i++], gates.*gate.value};
    if (gate.value == &Gates::color) continue;
    if (gate.value == &Gates::normals) v.is_measured = c.has_normals;
    if (gate.value == &Gates::color_share) {
      v.at_least = true;
      v.gate = needed_share(c, v.gate);
    }
    verdicts.push_back(v);
  }
  return verdicts;
}

bool all_hold(const std::vector<Verdict>& verdicts) {
  return std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.holds(); });
}

} // namespace rt::tools::povray
