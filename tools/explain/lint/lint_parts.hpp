#pragma once

#include "lang/check/lint/rules.hpp"
#include "lang/diagnostics/diagnostic.hpp"
#include "renderer/render/ray_query.hpp"
#include "tools/explain/lint/lint.hpp"
#include "tools/explain/naming.hpp"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// The parts of the lint that look at a scene's description and at its rays.
namespace rt::tools::explain {

/// A line of the scene's text, in order of place.
struct Line {
  std::uint32_t file = 0, number = 0;
  friend auto operator<=>(const Line&, const Line&) = default;
};
inline Line line_of(scene::Origin origin) {
  return {origin.file, origin.line};
}

/// What the picture's pixel centres meet first.
struct LintView {
  std::uint64_t rays = 0, hits = 0;
  std::set<Line> lines;           ///< of the shapes, and of the composites around them
  std::set<std::uint64_t> orders; ///< of the shapes, as `HitReport::order`
};

/// How one light fares at the surfaces that the picture shows.
struct LightTally {
  bool is_lit = false;       ///< some surface gets light from it
  std::uint64_t dark = 0;    ///< there is none to get: outside of a spot's cone, or it has none
  std::uint64_t averted = 0; ///< the surface faces the other way
  std::uint64_t blocked = 0;
  std::map<Line, std::uint64_t> blockers; ///< of some of those
};

/// Two opaque surfaces in one place that look different.
struct Coincidence {
  std::uint64_t count = 0;
  std::string first, second; ///< what they are called
};

/// What a sample of the pixels shows with all its reflections, refractions and shadows.
struct LintSurvey {
  std::uint64_t rays = 0;
  std::uint64_t surfaces = 0;               ///< rays that hit something
  std::uint64_t black = 0;                  ///< of these, as the picture shows it
  std::uint64_t clipped = 0;                ///< of these, in some channel
  std::uint64_t cut_off = 0;                ///< rays with a branch of some weight beyond max_depth
  std::map<Line, std::uint64_t> cut_off_at; ///< the surface it began at
  std::set<Line> lines;                     ///< seen in any way
  std::vector<LightTally> lights;
  std::map<std::pair<Line, Line>, Coincidence> coincidences; ///< the nearer first
};

/// A solid around a point.
struct Around {
  std::uint64_t order = 0;
  std::vector<const scene::Object*> objects; ///< from the scene's list inwards
  bool is_transparent = false;
  bool casts_shadow = true;
};

/// Warnings as they are found.
class Findings {
public:
  Findings(const scene::Scene& scene, const lang::SourceMap& sources)
      : namer_(scene, scene.files.empty() ? std::string_view() : scene.files.front()), sources_(sources) {}

  /// A warning at a line, or about the scene as a whole where nothing was written (line 0).
  lang::Diagnostic& warn(const lang::LintRule& rule, Line line, std::string message);
  lang::Note note(Line line, std::string message) const;
  /// "`ball` (line 3)", "the sphere (line 3)", with the file where it is another one than the scene's.
  std::string name(const scene::Object& object) const;
  /// What a line's warning calls what the line places, of which there are `count`: "`ball`", "this sphere", "each
  /// sphere of this line (3 of them)".
  static std::string subject(const std::string& name, std::uint64_t count);
  std::string place(Line line) const;

  std::vector<lang::Diagnostic> take() { return std::move(found_); }

private:
  lang::Span span(Line line) const;

  Namer namer_;
  const lang::SourceMap& sources_;
  std::vector<lang::Diagnostic> found_;
};

inline bool is_stopped(const LintOptions& options) {
  return options.stop && *options.stop;
}

/// Calls work(row, worker) for each row, from as many threads as the options say; `workers_of` says how many. Rows are
/// left out once it is stopped.
int workers_of(const LintOptions& options);
void for_each_row(const LintOptions& options, int rows, const std::function<void(int row, int worker)>& work);

/// What the rules work on.
struct LintContext {
  const scene::Scene& scene;
  const RayQuery& query;
  const LintOptions& options;
  LintView view;
  LintSurvey survey;
  std::vector<Around> around_eye;
  Findings& findings;
  bool is_eye_shut_in = false;   ///< reported: darkness follows from it
  std::set<Line> shut_in_lights; ///< reported: that they reach nothing follows from it
};

inline constexpr std::uint64_t most_pixels = 600'000;
inline constexpr std::uint64_t survey_rays = 8'000;
inline constexpr std::uint64_t most_leaves = 300'000;

/// What a hit shape is called by: the combination it is part of, if it is, else the shape itself.
const scene::Object& thing_of(const std::vector<const scene::Object*>& objects);

/// A shape (or a whole combination) as it stands in the scene.
struct LintLeaf {
  const scene::Object* object = nullptr;
  Affine to_scene;
  scene::MaterialId material = scene::no_material; ///< its own or the nearest composite's
  std::uint64_t order = 0;
  Box3 box; ///< in the scene's space
};
/// Calls `look` for each in the order of declaration. False if there are more than `most_leaves`: the rest was left
/// out.
bool for_each_leaf(const scene::Scene& scene, const std::function<void(const LintLeaf&)>& look);

LintView view_of(const LintContext& context);
/// `rays`: about how many pixels it is to trace.
LintSurvey survey_of(const LintContext& context, std::uint64_t rays);
/// The solids that hold `p`, but for planes, which are walls rather than solids.
std::vector<Around> solids_around(const LintContext& context, const Vec3& p);
/// Whether a shape hit has an inside.
bool is_solid(const scene::Scene& scene, const std::vector<const scene::Object*>& objects);

// The rules, by what they look at.
void find_small_scales(LintContext& context);
void find_insides(LintContext& context);
void find_empty_view(LintContext& context);
void find_unseen(LintContext& context);
void find_coincidences(LintContext& context);
void find_overlaps(LintContext& context);
void find_dark_lights(LintContext& context);
void find_exposure(LintContext& context);
void find_cut_off_rays(LintContext& context);

/// The picture's geometry for points of the scene.
class Projector {
public:
  explicit Projector(const scene::Scene& scene);
  /// Along the view; negative behind the eye.
  double depth(const Vec3& p) const { return dot(p - eye_, forward_); }
  /// In pixels from the top left; requires a positive depth.
  Vec3 pixel(const Vec3& p) const;
  /// In degrees: how far to the right of the view's middle, and how far up.
  std::pair<double, double> angles(const Vec3& p) const;
  /// The box's extent in pixels, both at least 0; nothing where part of it is behind the eye. `is_in_view` says whether
  /// it overlaps the picture.
  struct Extent {
    double width = 0, height = 0;
    bool is_in_view = false;
  };
  std::optional<Extent> extent(const Box3& box) const;

private:
  Vec3 eye_, forward_, right_, up_;
  double half_width_, width_, height_;
  bool is_orthographic_;
};
/// The corners of a finite box.
std::array<Vec3, 8> corners(const Box3& box);

} // namespace rt::tools::explain
