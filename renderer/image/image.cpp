#include "renderer/image/image.hpp"

#include "renderer/image/file.hpp"
#include "renderer/image/formats.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <stdexcept>

namespace rt {
namespace {

struct NamedFormat {
  std::string_view name;
  ImageFormat format;
};
constexpr std::array<NamedFormat, 4> formats{
    {{"png", ImageFormat::png}, {"exr", ImageFormat::exr}, {"ppm", ImageFormat::ppm}, {"pfm", ImageFormat::pfm}}};

} // namespace

std::optional<ImageFormat> format_by_name(std::string_view name) {
  for (const NamedFormat& known : formats)
    if (known.name == name) return known.format;
  return std::nullopt;
}

std::optional<ImageFormat> format_of(std::string_view path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string_view::npos || path[dot] == '/') return std::nullopt;
  std::string extension(path.substr(dot + 1));
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return format_by_name(extension);
}

std::string encode(const Film& film, ImageFormat format, const EncodeOptions& options) {
  switch (format) {
  case ImageFormat::png:
    return image::encode_png(film, options);
  case ImageFormat::exr:
    return image::encode_exr(film, options);
  case ImageFormat::ppm:
    return image::encode_ppm(film, options);
  case ImageFormat::pfm:
    return image::encode_pfm(film);
  }
  return {};
}

Image decode(std::string_view bytes, const std::string& name, Transfer assumed) {
  using std::string_view_literals::operator""sv;
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return image::decode_png(bytes, name, assumed);
  if (bytes.starts_with("\x76\x2f\x31\x01"sv)) return image::decode_exr(bytes, name);
  if (bytes.starts_with("PF"sv) || bytes.starts_with("Pf"sv)) return image::decode_pfm(bytes, name);
  for (const std::string_view magic : {"P2"sv, "P3"sv, "P5"sv, "P6"sv})
    if (bytes.starts_with(magic)) return image::decode_pnm(bytes, name, assumed);
  throw std::runtime_error(fmt::format("`{}` is not a supported picture file (png, exr, ppm, pgm or pfm)", name));
}

Image read_image(const std::string& path, Transfer assumed) {
  return decode(read_file(path), path, assumed);
}

namespace image {

Image empty_image(std::uint64_t width, std::uint64_t height, int bits, const std::string& name) {
  constexpr std::uint64_t longest = 1 << 20, most = 1 << 28;
  if (width == 0 || height == 0 || width > longest || height > longest || width * height > most)
    throw std::runtime_error(fmt::format("`{}` cannot be read: a picture of {} × {} pixels", name, width, height));
  Image image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.bits = bits;
  image.color.resize(width * height);
  return image;
}

} // namespace image
} // namespace rt
