#pragma once

#include "renderer/image/image.hpp"
#include "renderer/render/render.hpp"
#include "renderer/scene/scene.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Pictures of path mode that keep their sums (.exr with `Film::sums`): what they say of themselves, so that further
/// samples can be added.
namespace rt::tools {

/// What the sums of a picture are of.
struct SumsLabel {
  std::string samples_hash;      ///< of all that a sample depends on
  std::vector<SamplePart> parts; ///< that are in them, sorted; none: the whole
  ToneMapping tone_mapping;      ///< how the scene wants its light to be shown
};

/// Of a scene's picture. Nothing of the scene is changed.
SumsLabel label_of(scene::Scene& scene, const SamplePart& part);
/// As attributes of an exr.
std::vector<std::pair<std::string, std::string>> attributes(const SumsLabel& label);
/// Whether the key is that of one.
bool is_label_key(std::string_view key);
/// Of a picture that was read. Throws UsageError for one without sums; `path` is for its message.
SumsLabel label_of(const Image& image, const std::string& path);

/// A picture with sums. Throws as `read_image` does, and UsageError for one without.
struct PictureWithSums {
  std::string path;
  Image image;
  SumsLabel label;
};
PictureWithSums read_with_sums(const std::string& path);

/// "2/4"; nothing for what is no part.
std::optional<SamplePart> part_of(std::string_view text);

} // namespace rt::tools
