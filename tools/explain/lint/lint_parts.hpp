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

/// The parts of the lint that examine a scene's description and its rays.
namespace rt::tools::explain {

/// A line of the scene's text, ordered by place.
struct Line {
  std::uint32_t file = 0, number = 0;
  friend auto operator<=>(const Line&, const Line&) = default;
};
inline Line line_of(scene::Origin origin) {
  return {origin.file, origin.line};
}

/// What the picture's pixel centres hit first.
struct LintView {
  std::uint64_t rays = 0, hits = 0;
  std::set<Line> lines;           ///< of the shapes, and of the composites around them
  std::set<std::uint64_t> orders; ///< of the shapes, by `HitReport::order`
};

/// How one light performs at the surfaces that the picture shows.
struct LightTally {
  bool is_lit = false;       ///< some surface is lit by it
  std::uint64_t dark = 0;    ///< no light to receive: outside a spot's cone, or it emits none
  std::uint64_t averted = 0; ///< the surface faces away from it
  std::uint64_t blocked = 0;
  std::map<Line, std::uint64_t> blockers; ///< of some of them
};

/// Two coincident opaque surfaces that look different.
struct Coincidence {
  std::uint64_t count = 0;
  std::string first, second; ///< their names
};

/// The findings from a sample of the pixels with all their reflections, refractions and shadows.
struct LintSurvey {
  std::uint64_t rays = 0;
  std::uint64_t surfaces = 0;               ///< rays that hit something
  std::uint64_t black = 0;                  ///< of these, as displayed
  std::uint64_t clipped = 0;                ///< of these, in some channel
  std::uint64_t cut_off = 0;                ///< rays with a branch of significant weight beyond max_depth
  std::map<Line, std::uint64_t> cut_off_at; ///< the surface it began at
  std::set<Line> lines;                     ///< seen in any way
  std::vector<LightTally> lights;
  std::map<std::pair<Line, Line>, Coincidence> coincidences; ///< the nearer one first
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

  /// A warning at a line, or about the scene as a whole (line 0).
  lang::Diagnostic& warn(const lang::LintRule& rule, Line line, std::string message);
  lang::Note note(Line line, std::string message) const;
  /// "`ball` (line 3)", "the sphere (line 3)", with the file if it is not the scene's.
  std::string name(const scene::Object& object) const;
  /// How a line's warning refers to what the line places, of which there are `count`: "`ball`", "this sphere", "each
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

/// Calls work(row, worker) for each row, from as many threads as the options specify; `workers_of` gives their number.
/// Rows are skipped once it is stopped.
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
  bool is_eye_shut_in = false;   ///< reported: darkness is a consequence
  std::set<Line> shut_in_lights; ///< reported: that they reach nothing is a consequence
};

inline constexpr std::uint64_t most_pixels = 600'000;
inline constexpr std::uint64_t survey_rays = 8'000;
inline constexpr std::uint64_t most_leaves = 300'000;

/// The object by which a hit shape is named: the combination it is part of, if any, else the shape itself.
const scene::Object& thing_of(const std::vector<const scene::Object*>& objects);

/// A placed shape (or whole combination).
struct LintLeaf {
  const scene::Object* object = nullptr;
  Affine to_scene;
  scene::MaterialId material = scene::no_material; ///< its own or that of the nearest composite that has one
  std::uint64_t order = 0;
  Box3 box; ///< in scene space
};
/// Calls `look` for each in the order of declaration. False if there are more than `most_leaves`: the rest was
/// skipped.
bool for_each_leaf(const scene::Scene& scene, const std::function<void(const LintLeaf&)>& look);

LintView view_of(const LintContext& context);
/// `rays`: approximately how many pixels to trace.
LintSurvey survey_of(const LintContext& context, std::uint64_t rays);
/// The solids that contain `p`, except planes, which are walls rather than solids.
std::vector<Around> solids_around(const LintContext& context, const Vec3& p);
/// Whether a shape that was hit has an inside.
bool is_solid(const scene::Scene& scene, const std::vector<const scene::Object*>& objects);

// The rules, by what they examine.
void find_small_scales(LintContext& context);
void find_insides(LintContext& context);
void find_empty_view(LintContext& context);
void find_unseen(LintContext& context);
void find_coincidences(LintContext& context);
void find_overlaps(LintContext& context);
void find_dark_lights(LintContext& context);
void find_exposure(LintContext& context);
void find_cut_off_rays(LintContext& context);

/// Projects points of the scene to the picture.
class Projector {
public:
  explicit Projector(const scene::Scene& scene);
  /// Along the view direction; negative behind the eye.
  double depth(const Vec3& p) const { return dot(p - eye_, forward_); }
  /// In pixels from the top left; requires a positive depth.
  Vec3 pixel(const Vec3& p) const;
  /// In degrees: how far to the right of the view's centre, and how far up.
  std::pair<double, double> angles(const Vec3& p) const;
  /// The box's extent in pixels, both at least 0; nothing if part of it is behind the eye. `is_in_view` says whether it
  /// overlaps the picture.
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
