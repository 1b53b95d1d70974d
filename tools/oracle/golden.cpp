#include "tools/oracle/golden.hpp"

#include "renderer/image/image.hpp"
#include "renderer/render/render.hpp"

#include <fmt/format.h>
#include <png.h>

#include <sstream>
#include <stdexcept>

namespace rt::tools::oracle {
namespace {

using povray::Packed;

// FNV-1a (Fowler, Noll, Vo), 64 bits.
class Hash {
public:
  void add(std::string_view text) {
    for (const char c : text) {
      state_ ^= static_cast<unsigned char>(c);
      state_ *= 0x100000001b3;
    }
  }
  std::uint64_t value() const { return state_; }

private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

constexpr std::size_t layers = 3;

std::string png(const std::vector<Packed>& pixels, int width) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(pixels.size()) / image.width;
  image.format = PNG_FORMAT_LINEAR_RGB;
  png_alloc_size_t size = 0;
  const auto write = [&](void* to) {
    return png_image_write_to_memory(&image, to, &size, 0, pixels.data(), 0, nullptr) != 0;
  };
  std::string bytes;
  bool is_written = write(nullptr);
  if (is_written) {
    bytes.resize(size);
    is_written = write(bytes.data());
  }
  if (!is_written) throw std::runtime_error(fmt::format("cannot write a PNG picture: {}", image.message));
  bytes.resize(size);
  return bytes;
}

Film rendered(const scene::Scene& scene) {
  RenderOptions options;
  options.threads = 1;
  options.layers = true;
  options.integrator = IntegratorKind::whitted_exported;
  return render(scene, options).film;
}

} // namespace

std::string export_hash(const scene::Scene& scene) {
  Hash hash;
  for (const povray::Pass pass : {povray::Pass::color, povray::Pass::ids, povray::Pass::depth})
    hash.add(povray::export_povray(scene, {.pass = pass, .comments = false, .follows_every_ray = true}).text);
  return fmt::format("{:016x}", hash.value());
}

std::string encode_golden(const povray::Shots& shots) {
  std::vector<Packed> pixels = povray::to_16_bits(shots.color);
  for (const std::uint32_t id : shots.ids) pixels.push_back(povray::encode_id(id));
  for (const double depth : shots.depth) pixels.push_back(povray::encode_depth(depth));
  return png(pixels, shots.width);
}

povray::Shots decode_golden(const std::string& bytes, const std::string& name) {
  const Image image = decode(bytes, name, Transfer::linear);
  if (image.bits != 16 || image.height % static_cast<int>(layers) != 0)
    throw std::runtime_error(name + " is no picture of colours, objects and distances in 16 bits");
  povray::Shots shots{image.width, image.height / static_cast<int>(layers), {}, {}, {}, {}, false};
  const auto size = static_cast<std::ptrdiff_t>(image.color.size() / layers);
  shots.color.assign(image.color.begin(), image.color.begin() + size);
  const std::vector<Packed> packed = povray::to_16_bits({image.color.begin() + size, image.color.end()});
  for (std::size_t i = 0; i < packed.size(); ++i) {
    if (i < packed.size() / 2)
      shots.ids.push_back(povray::decode_id(packed[i]));
    else
      shots.depth.push_back(povray::decode_depth(packed[i]));
  }
  return shots;
}

GoldenIndex read_index(const std::string& text) {
  GoldenIndex index;
  std::istringstream lines(text);
  for (std::string name, hash; lines >> name >> hash;) index[name] = hash;
  return index;
}

std::string write_index(const GoldenIndex& index) {
  std::string text;
  for (const auto& [name, hash] : index) text += fmt::format("{} {}\n", name, hash);
  return text;
}

povray::Gates golden_gates() {
  povray::Gates gates;
  gates.color = 1.001 / 65535; // one count, plus the rounding of floats
  return gates;
}

povray::Comparison compare_with_golden(const scene::Scene& scene, const povray::Shots& golden) {
  scene::Scene sized = scene;
  sized.size = {golden.width, golden.height};
  return povray::compare(sized, rendered(sized), golden, golden_gates());
}

} // namespace rt::tools::oracle
