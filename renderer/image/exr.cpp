#include "renderer/image/cryptomatte.hpp"
#include "renderer/image/formats.hpp"
#include "renderer/image/sums_layer.hpp"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>
#include <unordered_map>

namespace rt::image {
namespace {

/// OpenEXR's output, kept in memory.
class StringOutput : public Imf::OStream {
public:
  explicit StringOutput(std::string& bytes) : OStream("picture"), bytes_(bytes) {}
  void write(const char data[], int size) override {
    const std::size_t end = at_ + static_cast<std::size_t>(size);
    if (bytes_.size() < end) bytes_.resize(end);
    std::memcpy(bytes_.data() + at_, data, static_cast<std::size_t>(size));
    at_ = end;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = position; }

private:
  std::string& bytes_;
  std::size_t at_ = 0;
};

class StringInput : public Imf::IStream {
public:
  StringInput(std::string_view bytes, const std::string& name) : IStream(name.c_str()), bytes_(bytes) {}
  bool read(char data[], int size) override {
    const std::size_t n = static_cast<std::size_t>(size);
    if (at_ > bytes_.size() || bytes_.size() - at_ < n) throw std::runtime_error("the file is truncated");
    std::memcpy(data, bytes_.data() + at_, n);
    at_ += n;
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override { at_ = position; }

private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// A channel of a file and the member of a row of pixels that holds it.
struct Channel {
  const char* name;
  Imf::PixelType type;
  std::size_t offset; ///< of the member in its pixel, bytes
};
constexpr Channel color_channels[] = {{"R", Imf::FLOAT, 0}, {"G", Imf::FLOAT, 4}, {"B", Imf::FLOAT, 8}};
constexpr Channel depth_channels[] = {{"depth.Z", Imf::FLOAT, 0}};
constexpr Channel normal_channels[] = {
    {"normal.X", Imf::FLOAT, 0}, {"normal.Y", Imf::FLOAT, 4}, {"normal.Z", Imf::FLOAT, 8}};
constexpr Channel position_channels[] = {
    {"position.X", Imf::FLOAT, 0}, {"position.Y", Imf::FLOAT, 4}, {"position.Z", Imf::FLOAT, 8}};
constexpr Channel object_channels[] = {{"object.id", Imf::UINT, 0}};
constexpr Channel albedo_channels[] = {
    {"albedo.R", Imf::FLOAT, 0}, {"albedo.G", Imf::FLOAT, 4}, {"albedo.B", Imf::FLOAT, 8}};

constexpr Channel error_channels[] = {
    {"error.R", Imf::FLOAT, 0}, {"error.G", Imf::FLOAT, 4}, {"error.B", Imf::FLOAT, 8}};
constexpr Channel samples_channels[] = {{"samples", Imf::UINT, 0}};

/// The nearest object of each pixel by the float of its name, and its coverage; there is no second object.
struct Matte {
  float id = 0, coverage = 0, second_id = 0, second_coverage = 0;
};
constexpr std::string_view matte_layer = "CryptoObject";
constexpr Channel matte_channels[] = {{"CryptoObject00.R", Imf::FLOAT, 0},
                                      {"CryptoObject00.G", Imf::FLOAT, 4},
                                      {"CryptoObject00.B", Imf::FLOAT, 8},
                                      {"CryptoObject00.A", Imf::FLOAT, 12}};

/// `ids` receives the names that occur.
std::vector<Matte> mattes(const Film& film, const EncodeOptions& options, std::map<std::string, std::uint32_t>& ids) {
  std::vector<Matte> pixels(film.object_id.size());
  std::unordered_map<std::uint32_t, float> known;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::uint32_t object = film.object_id[i];
    if (object == 0) continue;
    const auto [found, is_new] = known.try_emplace(object);
    if (is_new) {
      const std::string name = options.object_name(object);
      found->second = std::bit_cast<float>(ids[name] = matte_id(name));
    }
    pixels[i] = {found->second, 1, 0, 0};
  }
  return pixels;
}

/// Adds a slice for each channel to a frame buffer over `pixels`, whose first one is at `origin` in the file.
template <class Pixel>
void add_slices(Imf::FrameBuffer& frame, std::span<const Channel> channels, std::vector<Pixel>& pixels, int width,
                Imath::V2i origin) {
  for (const Channel& channel : channels) {
    char* member = reinterpret_cast<char*>(pixels.data()) + channel.offset;
    frame.insert(channel.name, Imf::Slice::Make(channel.type, member, origin, width, 1, sizeof(Pixel),
                                                sizeof(Pixel) * static_cast<std::size_t>(width)));
  }
}

bool has_all(const Imf::ChannelList& list, std::span<const Channel> channels) {
  return std::all_of(channels.begin(), channels.end(),
                     [&](const Channel& channel) { return list.findChannel(channel.name) != nullptr; });
}

std::vector<Channel> sums_layer() {
  std::vector<Channel> channels;
  for (const std::string& name : sums_channels())
    channels.push_back({name.c_str(), Imf::UINT, channels.size() * sizeof(std::uint32_t)});
  return channels;
}

void read_text(const Imf::Header& header, Image& image) {
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
      image.text[attribute.name()] = text->value();
}

/// Names the image's objects from its pixels' mattes.
void name_objects(Image& image, const std::vector<Matte>& mattes) {
  const std::map<std::uint32_t, std::string> names = matte_names(image.text);
  for (std::size_t i = 0; i < mattes.size(); ++i) {
    const auto name = names.find(std::bit_cast<std::uint32_t>(mattes[i].id));
    if (image.object_id[i] != 0 && name != names.end())
      image.object_names.try_emplace(image.object_id[i], name->second);
  }
}

/// Calls f(channels, pixels) for colour and for every layer of the film; `depth` replaces the film's own, which is
/// double.
template <class F>
void for_each_layer(Film& film, std::vector<float>& depth, F&& f) {
  f(depth_channels, depth);
  f(normal_channels, film.normal);
  f(position_channels, film.position);
  f(object_channels, film.object_id);
  f(albedo_channels, film.albedo);
}

} // namespace

std::string encode_exr(const Film& film, const EncodeOptions& options) {
  const Imath::V2i origin(film.left, film.top);
  const Imath::Box2i window(origin, origin + Imath::V2i(film.width - 1, film.height - 1));
  const Imath::Box2i picture({0, 0}, {film.picture_width - 1, film.picture_height - 1});
  Imf::Header header(film.picture_width > 0 ? picture : window, window);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [key, value] : options.text) header.insert(key, Imf::StringAttribute(value));

  Imf::FrameBuffer frame;
  const auto add = [&](const auto& channels, auto& pixels) {
    for (const Channel& channel : channels) header.channels().insert(channel.name, Imf::Channel(channel.type));
    add_slices(frame, channels, pixels, film.width, origin);
  };
  // OpenEXR's slices are used for reading too and so are not const; writing does not modify the film.
  Film& pixels = const_cast<Film&>(film);
  std::vector<float> depth(film.depth.begin(), film.depth.end());
  add(color_channels, pixels.color);
  if (film.has_layers()) {
    header.insert("depthMetric", Imf::StringAttribute("distance along the ray, infinite for a miss"));
    for_each_layer(pixels, depth, add);
  }
  std::vector<Matte> matte;
  if (film.has_layers() && options.object_name) {
    std::map<std::string, std::uint32_t> ids;
    matte = mattes(film, options, ids);
    for (const auto& [key, value] : matte_metadata(matte_layer, ids)) header.insert(key, Imf::StringAttribute(value));
    add(matte_channels, matte);
  }
  if (!film.error.empty()) {
    add(error_channels, pixels.error);
    add(samples_channels, pixels.samples);
  }
  std::vector<SumsWords> sums = sums_words(film);
  if (!sums.empty()) add(sums_layer(), sums);

  std::string bytes;
  StringOutput output(bytes);
  {
    Imf::OutputFile file(output, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(film.height);
  } // the table of line offsets is written when the file is closed
  return bytes;
}

Image decode_exr(std::string_view bytes, const std::string& name) try {
  StringInput input(bytes, name);
  Imf::InputFile file(input, 0);
  const Imf::ChannelList& list = file.header().channels();
  const Imath::Box2i window = file.header().dataWindow();
  const auto extent = [](int min, int max) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, std::int64_t{max} - min + 1));
  };
  Image image = empty_image(extent(window.min.x, window.max.x), extent(window.min.y, window.max.y), 32, name);

  Imf::FrameBuffer frame;
  const bool is_grey = !has_all(list, color_channels) && list.findChannel("Y") != nullptr;
  if (is_grey) {
    constexpr Channel grey_channels[] = {{"Y", Imf::FLOAT, 0}};
    add_slices(frame, grey_channels, image.color, image.width, window.min);
  } else {
    if (!has_all(list, color_channels)) throw std::runtime_error("it has neither R, G and B channels nor a Y channel");
    add_slices(frame, color_channels, image.color, image.width, window.min);
  }
  bool has_layers = true;
  std::vector<float> depth;
  for_each_layer(image, depth, [&](const auto& channels, auto&) { has_layers &= has_all(list, channels); });
  if (has_layers) {
    for_each_layer(image, depth, [&](const auto& channels, auto& pixels) {
      pixels.resize(image.color.size());
      add_slices(frame, channels, pixels, image.width, window.min);
    });
  }
  if (has_all(list, error_channels) && has_all(list, samples_channels)) {
    image.error.resize(image.color.size());
    image.samples.resize(image.color.size());
    add_slices(frame, error_channels, image.error, image.width, window.min);
    add_slices(frame, samples_channels, image.samples, image.width, window.min);
  }
  std::vector<Matte> mattes;
  if (has_layers && has_all(list, matte_channels)) {
    mattes.resize(image.color.size());
    add_slices(frame, matte_channels, mattes, image.width, window.min);
  }
  std::vector<SumsWords> sums;
  if (has_all(list, sums_layer())) {
    sums.resize(image.color.size());
    add_slices(frame, sums_layer(), sums, image.width, window.min);
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  image.depth.assign(depth.begin(), depth.end());
  set_sums(image, sums);
  read_text(file.header(), image);
  name_objects(image, mattes);
  std::erase_if(image.text, [](const auto& entry) { return is_matte_key(entry.first); });
  const Imath::Box2i picture = file.header().displayWindow();
  image.left = window.min.x - picture.min.x;
  image.top = window.min.y - picture.min.y;
  image.picture_width = picture.max.x - picture.min.x + 1;
  image.picture_height = picture.max.y - picture.min.y + 1;
  if (is_grey)
    for (Rgb32& c : image.color) c.g = c.b = c.r;
  return image;
} catch (const std::exception& error) {
  throw std::runtime_error(fmt::format("`{}` cannot be read: {}", name, error.what()));
}

} // namespace rt::image
