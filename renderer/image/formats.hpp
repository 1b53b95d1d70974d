#pragma once

#include "renderer/image/image.hpp"

/// A pair of functions for each file format; `encode` and `decode` choose among them. A decoder's `name` is for its
/// messages (std::runtime_error).
namespace rt::image {

std::string encode_png(const Film& film, const EncodeOptions& options);
std::string encode_exr(const Film& film, const EncodeOptions& options);
std::string encode_ppm(const Film& film, const EncodeOptions& options);
std::string encode_pfm(const Film& film);

Image decode_png(std::string_view bytes, const std::string& name, Transfer assumed);
Image decode_exr(std::string_view bytes, const std::string& name);
/// Binary and text PPM and PGM (P2, P3, P5, P6) of up to 16 bits.
Image decode_pnm(std::string_view bytes, const std::string& name, Transfer assumed);
Image decode_pfm(std::string_view bytes, const std::string& name);

/// An uninitialised image. Throws std::runtime_error for a size that no picture can have.
Image empty_image(std::uint64_t width, std::uint64_t height, int bits, const std::string& name);

} // namespace rt::image
