#include "tools/rtlang/picture_sums.hpp"

#include "tools/inspect/scene_hash.hpp"
#include "tools/live/picture_settings.hpp"
#include "tools/terminal/exit_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace rt::tools {
namespace {

constexpr std::string_view hash_key = "sumsOf", parts_key = "sumsParts", exposure_key = "sumsExposure",
                           tone_key = "sumsTone";

std::string value_of(const Image& image, std::string_view key) {
  const auto entry = image.text.find(std::string(key));
  return entry == image.text.end() ? "" : entry->second;
}

} // namespace

// The number of samples and the display of their light do not change a sample.
SumsLabel label_of(scene::Scene& scene, const SamplePart& part) {
  SumsLabel label{{}, {}, tone_mapping(scene)};
  scene::Settings& settings = scene;
  const scene::Settings written = settings;
  settings.samples.reset();
  settings.noise.reset();
  settings.exposure.reset();
  settings.tone.reset();
  label.samples_hash = scene_hash(scene);
  settings = written;
  if (!part.is_whole()) label.parts.push_back(part);
  return label;
}

std::vector<std::pair<std::string, std::string>> attributes(const SumsLabel& label) {
  std::vector<std::pair<std::string, std::string>> list{{std::string(hash_key), label.samples_hash}};
  std::string parts;
  for (const SamplePart& part : label.parts)
    parts += fmt::format("{}{}/{}", parts.empty() ? "" : " ", part.index, part.count);
  if (!parts.empty()) list.emplace_back(parts_key, parts);
  if (label.tone_mapping.exposure != 0) list.emplace_back(exposure_key, fmt::format("{}", label.tone_mapping.exposure));
  if (label.tone_mapping.tone == Tone::filmic) list.emplace_back(tone_key, "filmic");
  return list;
}

bool is_label_key(std::string_view key) {
  return key == hash_key || key == parts_key || key == exposure_key || key == tone_key;
}

SumsLabel label_of(const Image& image, const std::string& path) {
  SumsLabel label;
  label.samples_hash = value_of(image, hash_key);
  if (image.sums.empty() || label.samples_hash.empty())
    throw UsageError(fmt::format("`{}` has no sums to add to: render it with --sums or --part", path));
  const std::string parts = value_of(image, parts_key), exposure = value_of(image, exposure_key);
  for (std::string_view rest = parts; !rest.empty();) {
    const std::string_view word = rest.substr(0, rest.find(' '));
    if (const auto part = part_of(word)) label.parts.push_back(*part);
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
  }
  std::from_chars(exposure.data(), exposure.data() + exposure.size(), label.tone_mapping.exposure);
  if (value_of(image, tone_key) == "filmic") label.tone_mapping.tone = Tone::filmic;
  return label;
}

PictureWithSums read_with_sums(const std::string& path) {
  PictureWithSums picture{path, read_image(path), {}};
  picture.label = label_of(picture.image, path);
  return picture;
}

std::optional<SamplePart> part_of(std::string_view text) {
  const auto numbers = live::parse_numbers(text, '/', 2);
  if (!numbers) return std::nullopt;
  const SamplePart part{(*numbers)[0], (*numbers)[1]};
  const bool is_part = part.index >= 1 && part.index <= part.count && part.count <= scene::most_samples / 2;
  return is_part ? std::optional(part) : std::nullopt;
}

} // namespace rt::tools
