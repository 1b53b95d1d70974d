#include "tools/bench/peers/picture.hpp"
#include "tools/bench/process.hpp"
#include "tools/bench/scenes/layout.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

// Renders the measured scenes with rtlang, POV-Ray and Tachyon, with one thread each, and prints a table of the costs
// in Markdown. Every figure of a row is the minimum of several interleaved runs, so that other load on the machine
// hardly affects the ratios.
namespace rt::tools::bench {
namespace {

namespace fs = std::filesystem;

struct Program {
  std::string name;
  Format format;
  std::string extension;
  std::string picture;
};

const std::array<Program, 3> programs = {{{"rtlang", Format::rtl, ".rtl", ".rtl.png"},
                                          {"POV-Ray", Format::povray, ".pov", ".pov.png"},
                                          {"Tachyon", Format::tachyon, ".dat", ".dat.png"}}};

struct Options {
  std::string rtlang = "rtlang";
  std::vector<std::string> scenes{layout_names.begin(), layout_names.end()};
  int runs = 3;
  std::string folder = "bench_peers.tmp";
  bool keeps = false;
  bool is_checked = true;
};

Command command(const Options& options, const Program& program, const std::string& scene) {
  const std::string side = std::to_string(picture_size);
  if (program.format == Format::povray)
    return {
        "povray", "+I" + scene + ".pov", "+O" + scene + ".pov.png", "-D", "-A", "-GA", "+W" + side, "+H" + side, "+WT1",
        "+FN"};
  if (program.format == Format::tachyon)
    return {"tachyon", scene + ".dat", "-numthreads",     "1", "-res", side, side, "-format",
            "PNG",     "-o",           scene + ".dat.png"};
  return {options.rtlang, "render", scene + ".rtl", "-o", scene + ".rtl.png", "--threads", "1"};
}

struct Row {
  std::string scene;
  std::size_t primitives = 0;
  std::array<Cost, 3> costs;
  double differs_from_povray = 0, differs_from_tachyon = 0; // fractions of the pixels
  double ratio(std::size_t program) const { return costs[program].user_seconds / costs[0].user_seconds; }
};

Cost least(const Cost& a, const Cost& b) {
  return {std::min(a.user_seconds, b.user_seconds), std::min(a.system_seconds, b.system_seconds),
          std::min(a.wall_seconds, b.wall_seconds), std::min(a.peak_megabytes, b.peak_megabytes)};
}

// Linear pictures of the peers, made for this comparison and not measured.
void compare(const Options& options, const std::string& scene, Row& row) {
  const std::string base = options.folder + "/" + scene;
  Command povray = command(options, programs[1], scene), tachyon = command(options, programs[2], scene);
  povray.push_back("File_Gamma=1.0");
  std::replace(tachyon.begin(), tachyon.end(), std::string("PNG"), std::string("PPM"));
  tachyon.back() = scene + ".ppm";
  run(povray, options.folder, "check.log");
  run(tachyon, options.folder, "check.log");
  run_apart([&] {
    constexpr double tolerance = 4;
    const Picture ours = read_png(base + ".rtl.png", Encoding::srgb);
    std::ofstream(base + ".differs") << share_that_differs(ours, read_png(base + ".pov.png", Encoding::linear),
                                                           tolerance)
                                     << ' ' << share_that_differs(ours, read_ppm(base + ".ppm"), tolerance);
  });
  std::ifstream(base + ".differs") >> row.differs_from_povray >> row.differs_from_tachyon;
}

Row measure(const Options& options, const std::string& scene) {
  const std::string base = options.folder + "/" + scene;
  run_apart([&] {
    const Layout layout = make_layout(scene);
    for (const Program& program : programs) std::ofstream(base + program.extension) << write(layout, program.format);
    std::ofstream(base + ".count") << layout.primitive_count();
  });
  Row row;
  row.scene = scene;
  std::ifstream(base + ".count") >> row.primitives;
  for (int i = 0; i < options.runs; ++i)
    for (std::size_t p = 0; p < programs.size(); ++p) {
      const Cost cost = run(command(options, programs[p], scene), options.folder, "run.log");
      row.costs[p] = i == 0 ? cost : least(row.costs[p], cost);
    }
  if (options.is_checked) compare(options, scene, row);
  return row;
}

void print_row(const Row& row, bool is_checked) {
  const auto& [r, p, t] = row.costs;
  fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} | **{:.2f}** | **{:.2f}** | {:.2f} / {:.2f} / {:.2f} | {:.0f} / "
             "{:.0f} / {:.0f} |",
             row.scene, row.primitives, r.user_seconds, p.user_seconds, t.user_seconds, row.ratio(1), row.ratio(2),
             r.wall_seconds, p.wall_seconds, t.wall_seconds, r.peak_megabytes, p.peak_megabytes, t.peak_megabytes);
  if (is_checked) fmt::print(" {:.3f} / {:.3f} |", 100 * row.differs_from_povray, 100 * row.differs_from_tachyon);
  fmt::print("\n");
  std::fflush(stdout);
}

void print_means(const std::vector<Row>& rows) {
  for (const std::size_t p : {1, 2}) {
    double sum = 0, lowest = rows.front().ratio(p);
    for (const Row& row : rows) sum += std::log(row.ratio(p)), lowest = std::min(lowest, row.ratio(p));
    fmt::print("{} / rtlang: geometric mean **{:.2f}**, least **{:.2f}**.  \n", programs[p].name,
               std::exp(sum / static_cast<double>(rows.size())), lowest);
  }
}

void report(const Options& options) {
  fs::create_directories(options.folder);
  fmt::print("| scene | primitives | rtlang, s | POV-Ray, s | Tachyon, s | POV-Ray / rtlang | Tachyon / rtlang | wall, "
             "s | peak, MB |{}\n",
             options.is_checked ? " pixels that differ, % |" : "");
  fmt::print("|---|---|---|---|---|---|---|---|---|{}\n", options.is_checked ? "---|" : "");
  std::vector<Row> rows;
  for (const std::string& scene : options.scenes) {
    rows.push_back(measure(options, scene));
    print_row(rows.back(), options.is_checked);
    if (!options.keeps)
      for (const auto& entry : fs::directory_iterator(options.folder)) fs::remove(entry.path());
  }
  fmt::print("\n");
  print_means(rows);
  fmt::print("\nThe commands, here for the first scene:\n\n```\n");
  for (const Program& program : programs) {
    Command words = command(options, program, options.scenes.front());
    words.front() = fs::path(words.front()).filename().string();
    fmt::print("{}\n", shell_text(words));
  }
  fmt::print("```\n");
  if (!options.keeps) fs::remove_all(options.folder);
}

} // namespace
} // namespace rt::tools::bench

int main(int argc, char** argv) {
  using namespace rt::tools::bench;
  Options options;
  bool is_unchecked = false;
  CLI::App app{"Compares rtlang with POV-Ray and Tachyon on the same scenes"};
  app.add_option("--rtlang", options.rtlang, "the program to measure")->capture_default_str();
  app.add_option("--scenes", options.scenes, "which scenes")->delimiter(',');
  app.add_option("--runs", options.runs, "runs of each program; the least counts")->check(CLI::PositiveNumber);
  app.add_option("--folder", options.folder, "where scenes and pictures go")->capture_default_str();
  app.add_flag("--keep", options.keeps, "leave them there");
  app.add_flag("--no-check", is_unchecked, "do not compare the pictures");
  CLI11_PARSE(app, argc, argv);
  options.is_checked = !is_unchecked;
  try {
    if (options.rtlang.find('/') != std::string::npos) options.rtlang = fs::absolute(options.rtlang).string();
    report(options);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "bench_peers: " << error.what() << '\n';
    return 3;
  }
}
