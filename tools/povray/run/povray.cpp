#include "tools/povray/run/povray.hpp"

#include "renderer/image/file.hpp"
#include "renderer/image/image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <mutex>
#include <thread>

namespace rt::tools::povray {
namespace {

std::filesystem::path program() {
  std::filesystem::path found = find_program("povray");
  if (found.empty())
    throw Missing("POV-Ray is not installed: no program `povray` in PATH. Debian and Ubuntu have it as the package "
                  "`povray` (apt-get install povray)");
  return found;
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
}

// POV-Ray's output begins with pages of credits; its messages about the scene start where it parses.
std::string complaint(const std::string& errors) {
  const std::size_t parsing = errors.find("==== [Parsing");
  const std::size_t line = parsing == std::string::npos ? 0 : errors.find('\n', parsing);
  std::string text = line == std::string::npos ? std::string{} : errors.substr(line);
  const auto is_space = [](char c) { return c == '\n' || c == ' '; };
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), is_space));
  text.erase(std::find_if_not(text.rbegin(), text.rend(), is_space).base(), text.end());
  return text.substr(0, 2000);
}

constexpr int most_starts = 5;

// -D: no window, -A: no antialiasing, -P -V: no pauses and no progress output; all streams but that of errors are
// off.
void run(const ScratchFolder& folder, const std::string& text, int width, int height, const RunOptions& options) {
  write_file(folder.path() / "scene.pov", text);
  const std::vector<std::string> arguments{"+Iscene.pov",
                                           "+Oscene.ppm",
                                           "+FP16",
                                           fmt::format("+W{}", width),
                                           fmt::format("+H{}", height),
                                           "-D",
                                           "-A",
                                           "-P",
                                           "-V",
                                           "-GR",
                                           "-GS",
                                           "-GD",
                                           "-GW",
                                           fmt::format("+WT{}", std::max(1, options.threads)),
                                           "File_Gamma=1.0"};
  ProcessResult result;
  // On a busy machine POV-Ray may give up before it has begun.
  for (int start = 0; start < most_starts; ++start) {
    result = run_process(program(), arguments, folder.path(), options.time_limit, options.stop);
    if (result.exit_code == 0 || result.errors.find("Timed out waiting for worker thread startup") == std::string::npos)
      break;
  }
  if (result.stopped) throw Failed("stopped while POV-Ray was running");
  if (result.timed_out)
    throw Failed(
        fmt::format("POV-Ray did not finish within {} s", std::chrono::duration<double>(options.time_limit).count()));
  if (result.exit_code != 0)
    throw Failed(fmt::format("POV-Ray failed (exit code {}): {}", result.exit_code, complaint(result.errors)));
}

} // namespace

// While it renders, POV-Ray streams raw float pixels into a file named like the picture, for continuing an interrupted
// run, and removes it at the end. If that name is a link to another file, the data stay in that one.
Picture render(const std::string& text, int width, int height, const RunOptions& options) {
  const ScratchFolder folder;
  write_file(folder.path() / "state", {});
  std::filesystem::create_symlink("state", folder.path() / "scene.pov-state");
  run(folder, text, width, height, options);

  const Image file = read_image((folder.path() / "scene.ppm").string(), Transfer::linear);
  if (file.width != width || file.height != height || file.bits != 16)
    throw Failed("POV-Ray wrote no 16-bit picture of the requested size");
  Picture picture{width, height, file.color, to_16_bits(file.color), false};
  if (std::optional<std::vector<Rgb32>> state =
          read_render_state(rt::read_file((folder.path() / "state").string()), width, height)) {
    picture.color = std::move(*state);
    picture.is_float = true;
  }
  return picture;
}

std::string run_script(const std::string& text, const std::vector<ScriptFile>& inputs, const std::string& output,
                       const RunOptions& options) {
  const ScratchFolder folder;
  for (const ScriptFile& file : inputs) write_file(folder.path() / file.name, file.text);
  run(folder, text, 1, 1, options);
  if (!std::filesystem::exists(folder.path() / output)) throw Failed("POV-Ray did not write " + output);
  return rt::read_file((folder.path() / output).string());
}

std::string version() {
  const ScratchFolder folder;
  const ProcessResult result = run_process(program(), {"--version"}, folder.path(), std::chrono::seconds(20));
  const std::string key = "POV-Ray ";
  std::size_t begin = result.errors.find(key + "3");
  if (begin == std::string::npos) return "unknown";
  begin += key.size();
  return result.errors.substr(begin, result.errors.find_first_of(" \n", begin) - begin);
}

void run_many(std::size_t count, int at_once, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto loop = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::jthread> threads;
  const std::size_t helpers = std::min(count, static_cast<std::size_t>(std::max(1, at_once)));
  for (std::size_t i = 0; i < helpers; ++i) threads.emplace_back(loop);
  threads.clear();
  if (failure) std::rethrow_exception(failure);
}

} // namespace rt::tools::povray
