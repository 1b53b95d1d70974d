#pragma once

#include "renderer/scene/scene.hpp"

#include <string>
#include <vector>

/// A scene as POV-Ray 3.7 reads it. The exporter only reads the description: the steps, vectors and numbers as
/// written. It shares no derived quantity with the renderer, because its purpose is to find the renderer's
/// errors.
namespace rt::tools::povray {

/// What the exported scene shows. All passes place the same geometry.
enum class Pass : std::uint8_t {
  color,   ///< the scene itself
  ids,     ///< the id of the first surface hit, see `decode_id`
  depth,   ///< the distance to it, see `decode_depth`
  normals, ///< its unit normal facing the viewer, signed, as linear colour
};

struct ExportOptions {
  Pass pass = Pass::color;
  bool comments = true;           ///< names and lines of the source
  bool follows_every_ray = false; ///< whatever the scene's `min_weight`: for pictures that are compared
};

/// Something in the scene that POV-Ray cannot be made to compute exactly.
struct Inexact {
  std::string message;  ///< one sentence, without a full stop
  scene::Origin origin; ///< line 0: the scene as a whole
};

struct Exported {
  std::string text;
  std::vector<Inexact> inexact; ///< empty: POV-Ray computes the same picture
};

/// The same text for the same description, on every machine.
Exported export_povray(const scene::Scene& scene, const ExportOptions& options = {});

/// Only the objects, as `#declare name = union { … }` without surfaces, for POV-Ray's `trace`. Empty if there are
/// none.
std::string export_geometry(const scene::Scene& scene, const std::string& name);

/// The three channels of a pixel of a pass as 16-bit integers: the value times 65535.
struct Packed {
  std::uint16_t r = 0, g = 0, b = 0;
};
/// The pixel of `Pass::ids`: 0 for a miss, else the object's id, from 1 in order of declaration. Invisible objects are
/// not counted; members of groups are, in every instance; a combination is one object. The ids are the same as
/// `Film::object_id`.
std::uint32_t decode_id(Packed pixel);
/// The pixel of `Pass::depth`: the distance with a relative error of at most 2⁻⁴², infinite for a miss.
double decode_depth(Packed pixel);

/// The inverse of the decoders.
Packed encode_id(std::uint32_t id);
Packed encode_depth(double distance);

} // namespace rt::tools::povray
