#pragma once

#include "renderer/render/film.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt {

/// The file formats for pictures: sRGB integers (png, ppm) or linear floats (exr, pfm).
enum class ImageFormat { png, exr, ppm, pfm };

/// By the file name's extension, in any case; empty if unknown.
std::optional<ImageFormat> format_of(std::string_view path);
/// By name: "png", "exr", "ppm", "pfm".
std::optional<ImageFormat> format_by_name(std::string_view name);

struct EncodeOptions {
  int bits = 8; ///< per sample, 8 or 16, in png and ppm
  /// Metadata of png and exr: keywords of 1 to 79 Latin-1 characters, and text of any length.
  std::vector<std::pair<std::string, std::string>> text;
  /// The name of each of the film's object ids; if given, an exr with layers also has them as a Cryptomatte.
  std::function<std::string(std::uint32_t id)> object_name = {};
};

/// The bytes of the file, the same for the same arguments on every machine: they contain no time stamp. png and ppm
/// apply the film's tone mapping and clip the result to 0 to 1; exr and pfm do neither. Only exr holds the film's
/// layers.
std::string encode(const Film& film, ImageFormat format, const EncodeOptions& options);

/// What the integers of a picture mean where its file does not say: sRGB, or linear light.
enum class Transfer { srgb, linear };

/// A picture that was read: linear colour whatever the file's encoding, and the layers of an exr written by `encode`.
struct Image : Film {
  int bits = 8; ///< per sample in the file: 8, 16 or 32
  /// From an exr: the text attributes, sorted by keyword, except those of the Cryptomatte; and its names for the film's
  /// objects, by id.
  std::map<std::string, std::string> text = {};
  std::map<std::uint32_t, std::string> object_names = {};
};

/// Reads png, exr, ppm, pgm and pfm, told apart by their first bytes; transparency is ignored. The sRGB and gAMA
/// chunks of a png are honoured; `assumed` applies to one without them and to ppm and pgm. Throws std::system_error
/// if the file cannot be read and std::runtime_error if it is not such a picture, both with the path in the
/// message.
Image read_image(const std::string& path, Transfer assumed = Transfer::srgb);
/// The same for a file's bytes; `name` is for messages.
Image decode(std::string_view bytes, const std::string& name, Transfer assumed = Transfer::srgb);

} // namespace rt
