#include "renderer/compile/compiled_scene.hpp"
#include "renderer/image/file.hpp"
#include "renderer/image/image.hpp"
#include "renderer/render/render.hpp"
#include "tools/inspect/object_ids.hpp"
#include "tools/inspect/scene_hash.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/help.hpp"
#include "tools/rtlang/picture_sums.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/rtlang/statistics.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"
#include "tools/terminal/progress_bar.hpp"
#include "tools/terminal/quantity.hpp"
#include "tools/terminal/version.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace rt::tools {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct RenderArguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<live::PictureSettings> picture;
  std::vector<std::string> outputs;
  std::string format; ///< for outputs whose name does not determine it; empty: png
  std::string crop;
  int bits = 8;
  int threads = 0;
  double seconds = 0; ///< at most; 0: as long as it takes
  std::optional<SamplePart> part;
  bool keeps_sums = false;
  std::string earlier; ///< a picture to be continued
  bool keeps_partial = false;
  std::string statistics; ///< "text", "json", or empty for the one line
};

/// "90s", "5m", "1.5h", or a number of seconds; nothing if it is not a positive time.
std::optional<double> seconds_of(std::string_view text) {
  double unit = 1;
  if (text.ends_with('s') || text.ends_with('m') || text.ends_with('h')) {
    unit = text.back() == 's' ? 1 : text.back() == 'm' ? 60 : 3600;
    text.remove_suffix(1);
  }
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !(number > 0) || !std::isfinite(number))
    return std::nullopt;
  return number * unit;
}

struct Output {
  std::string path;
  ImageFormat format;
};

bool is_terminal(const std::string& path) {
  if (path == "-") return ::isatty(STDOUT_FILENO) != 0;
  std::error_code nothing_there;
  if (!std::filesystem::is_character_file(path, nothing_there)) return false;
  const int file = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  const bool is_terminal = file >= 0 && ::isatty(file) != 0;
  if (file >= 0) ::close(file);
  return is_terminal;
}

bool shows_progress(const RenderArguments& arguments) {
  return error_is_terminal() && !arguments.scene->is_quiet && !arguments.scene->json_diagnostics;
}

/// During its lifetime it shows how long that has been.
class Waiting {
public:
  explicit Waiting(const std::function<void(double seconds)>& tell)
      : thread_([tell](const std::stop_token& stop) { run(tell, stop); }) {}

private:
  static void run(const std::function<void(double seconds)>& tell, const std::stop_token& stop) {
    const Clock::time_point start = Clock::now();
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, stop, std::chrono::milliseconds(100), [&] { return stop.stop_requested(); }))
      tell(seconds_since(start));
  }

  std::jthread thread_;
};

/// Where to write the picture and in which format. Without -o: a png in the current folder, named like the scene.
std::vector<Output> outputs(const RenderArguments& arguments) {
  std::vector<std::string> paths = arguments.outputs;
  if (paths.empty()) {
    if (arguments.scene->path == "-") throw UsageError("a scene from standard input needs -o FILE");
    paths.push_back(std::filesystem::path(arguments.scene->path).stem().string() + ".png");
  }
  if (std::count(paths.begin(), paths.end(), "-") > 1) throw UsageError("only one picture can go to standard output");
  if (std::any_of(paths.begin(), paths.end(), is_terminal))
    throw UsageError("a terminal cannot show a picture file: say -o FILE, or pass it on with `| …` or `> FILE`");
  std::vector<Output> list;
  for (const std::string& path : paths) {
    std::optional<ImageFormat> format = format_of(path);
    const bool needs_no_extension = path == "-" || is_stream(path);
    if (!format && !arguments.format.empty()) format = format_by_name(arguments.format);
    if (!format && needs_no_extension) format = ImageFormat::png;
    if (!format)
      throw UsageError(fmt::format("`{}` does not end in .png, .exr, .ppm or .pfm: choose one with --format", path));
    list.push_back({path, *format});
  }
  return list;
}

/// If a picture cannot be written, that should be known before it is rendered.
void require_folders(const std::vector<Output>& list) {
  for (const Output& output : list)
    if (output.path != "-") require_writable(output.path);
}

PixelRect crop(const std::string& text, const scene::Resolution& size) {
  const auto n = live::parse_numbers(text, ',', 4);
  const PixelRect rect{(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
  if (rect.x0 < 0 || rect.y0 < 0 || rect.x1 <= rect.x0 || rect.y1 <= rect.y0 || rect.x1 > size[0] || rect.y1 > size[1])
    throw UsageError(
        fmt::format("--crop {} is not within the picture of {}x{} (X1 and Y1 are exclusive)", text, size[0], size[1]));
  return rect;
}

/// The metadata of a picture in its file.
std::vector<std::pair<std::string, std::string>> text_of(const scene::Scene& scene, const std::string& hash,
                                                         bool is_exr, const std::optional<SumsLabel>& sums) {
  const std::string software = fmt::format("rtlang {}", version_number());
  if (!is_exr) return {{"Software", software}, {"Scene-Hash", hash}};
  std::vector<std::pair<std::string, std::string>> text{{"software", software}, {"sceneHash", hash}};
  if (!scene.is_random()) return text;
  text.emplace_back("mode", name(*scene.mode));
  text.emplace_back("seed", fmt::format("{}", scene.seed.value_or(0)));
  text.emplace_back("samples", fmt::format("{}", scene::sample_count(scene)));
  if (sums)
    for (auto& attribute : attributes(*sums)) text.push_back(std::move(attribute));
  return text;
}

void write(const std::vector<Output>& list, const Rendered& rendered, const RenderArguments& arguments,
           const scene::Scene& scene, const std::string& hash, const std::optional<SumsLabel>& sums) {
  const ObjectIds ids(scene);
  ProgressBar bar;
  for (const Output& output : list) {
    std::optional<Waiting> waiting;
    if (shows_progress(arguments))
      waiting.emplace(
          [&](double seconds) { bar.show(fmt::format("{}: writing for {:.0f} s", output.path, seconds), seconds); });
    const EncodeOptions options{arguments.bits, text_of(scene, hash, output.format == ImageFormat::exr, sums),
                                [&ids](std::uint32_t id) { return ids.name(id); }};
    const std::string bytes = [&] {
      // Nothing is half written yet. A partial picture is wanted in spite of the signal that interrupted it.
      std::optional<EndsAtOnce> encoding;
      if (rendered.is_complete) encoding.emplace();
      return encode(rendered.film, output.format, options);
    }();
    if (output.path == "-")
      print(bytes);
    else
      replace_file(output.path, bytes);
  }
}

void report(const RenderArguments& arguments, const RunStatistics& statistics) {
  if (arguments.statistics == "json")
    print(json(statistics));
  else if (arguments.statistics == "text")
    print_error(table(statistics));
  else if (!arguments.scene->is_quiet && !arguments.scene->json_diagnostics)
    print_error(summary(statistics));
}

/// The line of the thing that an object of the film belongs to: "ball (scene.rtl:12)".
std::string place_of(const scene::Scene& scene, std::uint32_t id) {
  const ObjectIds ids(scene);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::Origin& origin = scene.objects[i].origin;
    if (ids.range(i).first <= id && id <= ids.range(i).last)
      return fmt::format("{} ({}:{})", ids.name(id), scene.files[origin.file], origin.line);
  }
  return "nothing";
}

void warn_of_dropped(const scene::Scene& scene, const RenderStatistics& statistics) {
  if (!statistics.dropped) return;
  const RenderStatistics::Dropped& dropped = *statistics.dropped;
  print_error(fmt::format("rtlang: {} {} no finite light and count{} as black; the first in pixel ({}, {}), which "
                          "shows {}\n",
                          dropped.samples, dropped.samples == 1 ? "sample has" : "samples have",
                          dropped.samples == 1 ? "s" : "", dropped.x, dropped.y, place_of(scene, dropped.object_id)));
}

Rendered render_within_memory(const CompiledScene& compiled, const scene::Scene& scene, const RenderOptions& options) {
  try {
    View view = view_of(scene);
    if (options.time_limit) view.samples = scene.samples.value_or(scene::most_samples);
    return rt::render(compiled, view, options);
  } catch (const std::bad_alloc&) {
    const PixelRect rect = options.crop.value_or(PixelRect{0, 0, scene.size[0], scene.size[1]});
    const std::uint64_t sums = scene.is_random() ? sums_bytes(rect) : 0;
    throw std::runtime_error(fmt::format(
        "there is not enough memory: a picture of {}×{} pixels takes {}B{}", rect.width(), rect.height(),
        human(static_cast<double>(film_bytes(rect, options.layers) + sums)), options.layers ? " with its layers" : ""));
  }
}

Rendered render_with_progress(const RenderArguments& arguments, const scene::Scene& scene, RenderOptions options) {
  ProgressBar bar;
  if (shows_progress(arguments)) options.on_progress = [&bar](const Progress& progress) { bar.show(progress); };
  const Clock::time_point build_start = Clock::now();
  const auto compiled = [&] {
    const EndsAtOnce building;
    std::optional<Waiting> waiting;
    if (options.on_progress) waiting.emplace([&](double seconds) { options.on_progress({0, 0, seconds}); });
    return std::make_unique<const CompiledScene>(scene, options.threads);
  }();
  const double build_seconds = seconds_since(build_start);
  Rendered rendered = render_within_memory(*compiled, scene, options);
  rendered.statistics.primitives = scene::count_primitives(scene);
  rendered.statistics.build_seconds = build_seconds;
  return rendered;
}

/// Options that require random samples, and what else they require.
void require_path_options(const RenderArguments& arguments, const scene::Scene& scene, bool has_exr) {
  const auto require_path = [&](bool is_given, std::string_view option) {
    if (is_given && !scene.is_random())
      throw UsageError(fmt::format("{} cannot be used in whitted mode, whose samples cannot be added to", option));
  };
  if (arguments.seconds > 0 && !scene.is_random())
    throw UsageError("--time cannot be used in whitted mode, which has a fixed number of samples");
  require_path(arguments.part.has_value(), "--part");
  require_path(arguments.keeps_sums, "--sums");
  require_path(!arguments.earlier.empty(), "--continue");
  if (arguments.part && !has_exr) throw UsageError("--part writes sums, which only an .exr can store: use -o FILE.exr");
  if (arguments.part && scene.noise)
    throw UsageError("--part does not go with the scene's `noise`, which is that of all samples together");
}

/// The picture to be continued, if it is of this scene.
std::optional<PictureWithSums> earlier_picture(const RenderArguments& arguments, const SumsLabel& label,
                                               const PixelRect& rect) {
  if (arguments.earlier.empty()) return std::nullopt;
  std::optional<PictureWithSums> earlier = read_with_sums(arguments.earlier);
  const Image& image = earlier->image;
  if (earlier->label.samples_hash != label.samples_hash)
    throw UsageError(fmt::format("`{}` is from a different scene, size or seed", arguments.earlier));
  if (PixelRect{image.left, image.top, image.left + image.width, image.top + image.height} != rect)
    throw UsageError(fmt::format("`{}` shows a different part of the picture", arguments.earlier));
  if (earlier->label.parts != label.parts)
    throw UsageError(fmt::format("`{}` contains the samples of a different --part", arguments.earlier));
  return earlier;
}

int run_render(const RenderArguments& arguments) {
  const Clock::time_point start = Clock::now();
  const std::vector<Output> list = outputs(arguments);
  if (arguments.statistics == "json" &&
      std::any_of(list.begin(), list.end(), [](const Output& o) { return o.path == "-"; }))
    throw UsageError("--stats json writes to standard output, as the picture does");
  require_folders(list);

  RunStatistics statistics;
  lang::Loaded loaded = load(*arguments.scene);
  if (!loaded.scene) return exit_scene_is_wrong;
  loaded.sources = {}; // all diagnostics were reported, and the text may be large
  scene::Scene& scene = *loaded.scene;
  arguments.picture->apply_to(scene);
  statistics.load_seconds = seconds_since(start);

  RenderOptions options;
  options.threads = arguments.threads;
  options.stop = &stop_flag();
  options.layers = std::any_of(list.begin(), list.end(), [](const Output& o) { return o.format == ImageFormat::exr; });
  require_path_options(arguments, scene, options.layers);
  if (arguments.seconds > 0) options.time_limit = arguments.seconds;
  if (!arguments.crop.empty()) options.crop = crop(arguments.crop, scene.size);
  options.part = arguments.part.value_or(SamplePart{});
  options.sums = options.layers && (arguments.part || arguments.keeps_sums || !arguments.earlier.empty());
  std::optional<SumsLabel> label;
  if (options.sums || !arguments.earlier.empty()) label = label_of(scene, options.part);
  const auto earlier = earlier_picture(arguments, label.value_or(SumsLabel{}),
                                       options.crop.value_or(PixelRect{0, 0, scene.size[0], scene.size[1]}));
  if (earlier) options.earlier = &earlier->image;
  const Rendered rendered = render_with_progress(arguments, scene, options);
  if (!rendered.is_complete && (!arguments.keeps_partial || rendered.film.color.empty())) throw Interrupted{};

  const Clock::time_point write_start = Clock::now();
  statistics.scene_hash = scene_hash(scene);
  write(list, rendered, arguments, scene, statistics.scene_hash, label);
  statistics.write_seconds = seconds_since(write_start);

  statistics.scene = arguments.scene->path;
  for (const Output& output : list) statistics.outputs.push_back(output.path);
  statistics.width = rendered.film.width;
  statistics.height = rendered.film.height;
  statistics.is_complete = rendered.is_complete;
  statistics.load = loaded.statistics;
  statistics.render = rendered.statistics;
  statistics.total_seconds = seconds_since(start);
  if (!arguments.scene->json_diagnostics) warn_of_dropped(scene, rendered.statistics);
  report(arguments, statistics);
  if (!rendered.is_complete) throw Interrupted{};
  return exit_fine;
}

} // namespace

Action declare_render(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  app.add_option("-o,--output", arguments->outputs, ".png .exr .ppm or .pfm file, - for standard output")
      ->type_name("FILE")
      ->allow_extra_args(false);
  arguments->picture = add_picture_arguments(app);
  app.add_option("--crop", arguments->crop, "renders only this part, in pixels from the top left")
      ->type_name("X0,Y0,X1,Y1")
      ->check([](const std::string& text) {
        return live::parse_numbers(text, ',', 4) ? ""
                                                 : fmt::format("takes X0,Y0,X1,Y1, as in 0,0,400,300, not `{}`", text);
      })
      ->group(further_options);
  app.add_option("--bits", arguments->bits, "bits per channel in .png and .ppm: 8 or 16")
      ->type_name("N")
      ->check(one_of({"8", "16"}))
      ->group(further_options);
  app.add_option_function<std::string>(
         "--time", [arguments = arguments.get()](const std::string& text) { arguments->seconds = *seconds_of(text); },
         "not in whitted mode: samples for this long, as in 90s, 5m or 1.5h")
      ->type_name("T")
      ->check([](const std::string& text) {
        return seconds_of(text) ? "" : fmt::format("takes a time, as in 90s, 5m or 1.5h, not `{}`", text);
      })
      ->group(further_options);
  app.add_option_function<std::string>(
         "--part", [arguments = arguments.get()](const std::string& text) { arguments->part = part_of(text); },
         "not in whitted mode: only the k-th of n parts of the samples, for `rtlang merge`")
      ->type_name("K/N")
      ->check([](const std::string& text) {
        return part_of(text) ? "" : fmt::format("takes the k-th of n parts, as in 2/4, not `{}`", text);
      })
      ->group(further_options);
  app.add_flag("--sums", arguments->keeps_sums, "not in whitted mode: stores in an .exr what --continue needs")
      ->group(further_options);
  app.add_option("--continue", arguments->earlier,
                 "not in whitted mode: adds samples to this picture, made with --sums")
      ->type_name("PICTURE")
      ->group(further_options);
  app.add_option("--threads", arguments->threads, "number of threads (one per core)")
      ->type_name("N")
      ->check(whole_number(1, 1024));
  arguments->scene = add_scene_arguments(app);
  arguments->scene->options.needs_things = true;
  app.add_flag("--stats{text}", arguments->statistics, "prints timings and counts as a table, or as JSON")
      ->type_name("[json]")
      ->check(one_of({"text", "json"}));
  app.add_option("--format", arguments->format, "file format for - and other names: png (default), exr, ppm, pfm")
      ->type_name("NAME")
      ->check(one_of({"png", "exr", "ppm", "pfm"}))
      ->group(further_options);
  app.add_flag("--keep-partial", arguments->keeps_partial, "on Ctrl-C, writes the unfinished picture")
      ->group(further_options);
  app.footer("Without -o the picture is written to SCENE.png in the current folder.");
  return [arguments] { return run_render(*arguments); };
}

} // namespace rt::tools
