#include "renderer/image/file.hpp"
#include "renderer/image/image.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/picture_sums.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <tuple>

namespace rt::tools {
namespace {

struct MergeArguments {
  std::vector<std::string> pictures, outputs;
  int bits = 8;
  bool keeps_sums = false;
};

bool is_before(const SamplePart& a, const SamplePart& b) {
  return std::tuple(a.count, a.index) < std::tuple(b.count, b.index);
}

/// Requires pictures of the same scene, and of the same part of its picture.
void require_alike(const PictureWithSums& a, const PictureWithSums& b) {
  if (a.label.samples_hash != b.label.samples_hash)
    throw UsageError(fmt::format("`{}` and `{}` are of different scenes, sizes or seeds", a.path, b.path));
  const auto place = [](const Film& film) { return std::tuple(film.left, film.top, film.width, film.height); };
  if (place(a.image) != place(b.image))
    throw UsageError(fmt::format("`{}` and `{}` show different parts of the picture", a.path, b.path));
}

/// The parts of all pictures, which must have no samples in common.
std::vector<SamplePart> joined_parts(const std::vector<PictureWithSums>& pictures) {
  std::vector<SamplePart> parts;
  for (const PictureWithSums& picture : pictures) {
    if (picture.label.parts.empty())
      throw UsageError(fmt::format("`{}` already contains all samples of its picture", picture.path));
    for (const SamplePart& part : picture.label.parts) {
      if (part.count != pictures[0].label.parts[0].count)
        throw UsageError(fmt::format("`{}` is one of {} parts, and `{}` one of {}", pictures[0].path,
                                     pictures[0].label.parts[0].count, picture.path, part.count));
      if (std::find(parts.begin(), parts.end(), part) != parts.end())
        throw UsageError(fmt::format("part {}/{} is given twice, again in `{}`", part.index, part.count, picture.path));
      parts.push_back(part);
    }
  }
  std::sort(parts.begin(), parts.end(), is_before);
  if (parts.size() == static_cast<std::size_t>(parts[0].count)) return {};
  return parts;
}

void add(Film& film, const Film& other) {
  for (std::size_t i = 0; i < film.sums.size(); ++i) film.sums[i].add(other.sums[i]);
}

EncodeOptions encode_options(const Image& image, const SumsLabel& label, ImageFormat format, int bits) {
  const bool is_exr = format == ImageFormat::exr;
  EncodeOptions options{bits, {}, [&image](std::uint32_t id) {
                          const auto name = image.object_names.find(id);
                          return name == image.object_names.end() ? std::string() : name->second;
                        }};
  if (image.object_names.empty()) options.object_name = nullptr;
  for (const auto& [key, value] : image.text) {
    if (is_label_key(key)) continue;
    if (is_exr)
      options.text.emplace_back(key, value);
    else if (key == "software" || key == "sceneHash")
      options.text.emplace_back(key == "software" ? "Software" : "Scene-Hash", value);
  }
  if (!is_exr) std::sort(options.text.begin(), options.text.end(), std::greater<>());
  if (is_exr && !image.sums.empty())
    for (auto& attribute : attributes(label)) options.text.push_back(std::move(attribute));
  return options;
}

int run_merge(const MergeArguments& arguments) {
  std::vector<ImageFormat> formats;
  for (const std::string& path : arguments.outputs) {
    const auto format = format_of(path);
    if (!format) throw UsageError(fmt::format("`{}` does not end in .png, .exr, .ppm or .pfm", path));
    formats.push_back(*format);
    require_writable(path);
  }
  std::vector<PictureWithSums> pictures;
  for (const std::string& path : arguments.pictures) {
    pictures.push_back(read_with_sums(path));
    require_alike(pictures[0], pictures.back());
  }
  Image& sum = pictures[0].image;
  SumsLabel label = pictures[0].label;
  label.parts = joined_parts(pictures);
  for (std::size_t i = 1; i < pictures.size(); ++i) add(sum, pictures[i].image);
  show_sums(sum, !sum.error.empty());
  sum.tone_mapping = label.tone_mapping;
  if (label.parts.empty() && !arguments.keeps_sums) sum.sums.clear();
  for (std::size_t i = 0; i < formats.size(); ++i)
    replace_file(arguments.outputs[i], encode(sum, formats[i], encode_options(sum, label, formats[i], arguments.bits)));
  if (!label.parts.empty())
    print_error(fmt::format("rtlang: {} of {} parts: the picture is complete once the others are there\n",
                            label.parts.size(), label.parts[0].count));
  return exit_fine;
}

} // namespace

Action declare_merge(CLI::App& app) {
  auto arguments = std::make_shared<MergeArguments>();
  app.add_option("PICTURES", arguments->pictures, "parts of one picture: .exr files made with --part")
      ->required()
      ->group("");
  app.add_option("-o,--output", arguments->outputs, "output file: .png, .exr, .ppm or .pfm")
      ->type_name("FILE")
      ->required()
      ->allow_extra_args(false);
  app.add_option("--bits", arguments->bits, "bits per channel in .png and .ppm: 8 or 16")
      ->type_name("N")
      ->check(CLI::IsMember({8, 16}));
  app.add_flag("--sums", arguments->keeps_sums, "keeps the sums in a complete .exr, so that it can be continued");
  app.footer("Parts may be rendered on different machines: the result is byte-identical to a single render.");
  return [arguments] { return run_merge(*arguments); };
}

} // namespace rt::tools
