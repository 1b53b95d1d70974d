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

/// The kinds of files a picture is written to: sRGB in whole numbers (png, ppm) or linear floats (exr, pfm).
enum class ImageFormat { png, exr, ppm, pfm };

/// By the name's extension, in whatever case; empty for one that is not known.
std::optional<ImageFormat> format_of(std::string_view path);
/// By its name: "png", "exr", "ppm", "pfm".
std::optional<ImageFormat> format_by_name(std::string_view name);

struct EncodeOptions {
  int bits = 8; ///< of a sample, 8 or 16, in png and ppm
  /// Keywords and values that png and exr carry along: 1 to 79 Latin-1 characters, and any number of them.
  std::vector<std::pair<std::string, std::string>> text;
  /// What an id of the film's objects is called; with it an exr with layers has them as a Cryptomatte too.
  std::function<std::string(std::uint32_t id)> object_name = {};
};

/// The bytes of the file, the same for the same arguments on every machine: they hold no time stamp. png and ppm show
/// colours by the film's tone mapping and clip what is then beyond 0 to 1, exr and pfm keep them. Only exr holds the
/// film's layers.
std::string encode(const Film& film, ImageFormat format, const EncodeOptions& options);

/// What the whole numbers of a picture mean where its file does not say so: sRGB, or light itself.
enum class Transfer { srgb, linear };

/// A picture that was read: linear colour whatever the file's encoding, and the layers of an exr that `encode` wrote.
struct Image : Film {
  int bits = 8; ///< of a sample in the file: 8, 16 or 32
  /// Of an exr: the attributes that are text, sorted by their keywords, but those of the Cryptomatte; and what that
  /// calls the film's objects, by id.
  std::map<std::string, std::string> text = {};
  std::map<std::uint32_t, std::string> object_names = {};
};

/// Reads png, exr, ppm, pgm and pfm, told apart by their first bytes; transparency is ignored. png files are taken at
/// their word (the chunks sRGB and gAMA); `assumed` is for those without one and for ppm and pgm. Throws
/// std::system_error for a file that cannot be read and std::runtime_error for one that is no such picture, both with
/// the path in their message.
Image read_image(const std::string& path, Transfer assumed = Transfer::srgb);
/// The same for a file's bytes; `name` is for messages.
Image decode(std::string_view bytes, const std::string& name, Transfer assumed = Transfer::srgb);

} // namespace rt
