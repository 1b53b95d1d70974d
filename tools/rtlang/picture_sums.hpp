#pragma once

#include "renderer/image/image.hpp"
#include "renderer/render/render.hpp"
#include "renderer/scene/scene.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Pictures of path mode that keep their sums (.exr with `Film::sums`): their metadata, so that further samples can be
/// added.
namespace rt::tools {

/// What the sums of a picture belong to.
struct SumsLabel {
  std::string samples_hash;      ///< of everything that a sample depends on
  std::vector<SamplePart> parts; ///< contained in them, sorted; none: the whole
  ToneMapping tone_mapping;      ///< how the scene's light is to be displayed
};

/// For a scene's picture. The scene is not changed.
SumsLabel label_of(scene::Scene& scene, const SamplePart& part);
/// As attributes of an exr.
std::vector<std::pair<std::string, std::string>> attributes(const SumsLabel& label);
/// Whether the key is one of these attributes.
bool is_label_key(std::string_view key);
/// From a picture that was read. Throws UsageError if it has no sums; `path` is for the message.
SumsLabel label_of(const Image& image, const std::string& path);

/// A picture with sums. Throws as `read_image` does, and UsageError if it has none.
struct PictureWithSums {
  std::string path;
  Image image;
  SumsLabel label;
};
PictureWithSums read_with_sums(const std::string& path);

/// "2/4"; nothing if it is not a part.
std::optional<SamplePart> part_of(std::string_view text);

} // namespace rt::tools
