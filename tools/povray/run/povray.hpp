#pragma once

#include "renderer/render/film.hpp"
#include "tools/povray/export/export.hpp"
#include "tools/povray/run/process.hpp"

#include <functional>
#include <optional>

/// Running POV-Ray 3.7 and reading its output.
namespace rt::tools::povray {

/// POV-Ray is not installed. The message names the package.
class Missing : public std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// POV-Ray rejected the text, ran out of time or left nothing to read; the message contains its output.
class Failed : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct RunOptions {
  std::chrono::milliseconds time_limit = std::chrono::minutes(10);
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;
};

/// A picture of POV-Ray's, row by row from the top left.
struct Picture {
  int width = 0, height = 0;
  std::vector<Rgb32> color;   ///< linear; not clamped if `is_float`, else from `packed`
  std::vector<Packed> packed; ///< clamped to [0, 1], times 65535
  bool is_float = false;
};

/// Renders a scene file, one ray through each pixel's centre. Throws Missing or Failed; the scratch folder is removed
/// afterwards.
Picture render(const std::string& text, int width, int height, const RunOptions& options = {});

/// Runs a scene file for its output: `inputs` are files beside it, and the text of its file `output` is
/// returned.
struct ScriptFile {
  std::string name, text;
};
std::string run_script(const std::string& text, const std::vector<ScriptFile>& inputs, const std::string& output,
                       const RunOptions& options = {});

/// "3.7.0.10.unofficial", as reported by the program. Throws Missing.
std::string version();

/// The pictures of POV-Ray's render-state file: linear float, neither clamped nor rounded. Nothing if the bytes are not
/// such a file or do not cover the picture.
std::optional<std::vector<Rgb32>> read_render_state(const std::string& bytes, int width, int height);
/// Rounded to integers, clamped to [0, 1].
std::vector<Packed> to_16_bits(const std::vector<Rgb32>& color);

/// Calls `work(0)` … `work(count − 1)` on up to `at_once` threads, for work that mostly waits. An exception ends all of
/// it and is rethrown.
void run_many(std::size_t count, int at_once, const std::function<void(std::size_t)>& work);

} // namespace rt::tools::povray
