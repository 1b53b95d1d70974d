#include "tools/bench/bars/glass.hpp"

#include "tools/bench/process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rt::tools::bench {
namespace {

constexpr std::array depths{8, 12, 20};
constexpr int runs = 3;

struct Prices {
  double ours = 1e9, theirs = 1e9; // user seconds
};

// In turns, so that other load on the machine affects all alike.
std::array<Prices, depths.size()> prices(const std::string& program, const std::string& folder) {
  std::array<Prices, depths.size()> result;
  for (int turn = 0; turn < runs; ++turn) {
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const std::string depth = std::to_string(depths[i]), scene = RTLANG_SOURCE_DIR "/tools/bench/scenes/tumbler.rtl";
      const Command render{program, "render", scene, "-o", "tumbler.png", "-q", "--max-depth", depth, "--threads", "1"};
      const auto least = [&](double& seconds, const Command& command) {
        seconds = std::min(seconds, run(command, folder, "log").user_seconds);
      };
      least(result[i].ours, render);
      run({program, "export", scene, "-o", "tumbler.pov", "-q", "--max-depth", depth}, folder, "log");
      least(result[i].theirs,
            {"povray", "+Itumbler.pov", "+Otumbler.pov.png", "-D", "-A", "-GA", "+W600", "+H400", "+WT1", "+FN"});
    }
  }
  return result;
}

} // namespace

void measure_glass(const std::string& program, const std::string& folder,
                   const std::function<void(std::string_view, std::string_view)>& row) {
  const auto all = prices(program, folder);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const Prices& p = all[i];
    row(fmt::format("a tumbler of water (`scenes/tumbler.rtl`) at depth {}: with `min_weight`, POV-Ray with "
                    "`adc_bailout` as much, CPU",
                    depths[i]),
        fmt::format("{:.2f} s, {:.2f} s = {:.2f}×", p.ours, p.theirs, p.theirs / p.ours));
  }
  row("the tumbler at depth 20 against depth 8", fmt::format("{:.2f}×", all.back().ours / all.front().ours));
}

} // namespace rt::tools::bench
