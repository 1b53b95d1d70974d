#define SDL_MAIN_HANDLED
#include "tools/preview/camera_moves.hpp"
#include "tools/preview/file_watch.hpp"
#include "tools/preview/viewer.hpp"
#include "tools/preview/window.hpp"

#include <SDL.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace rt::tools::preview {
namespace {

constexpr std::string_view instead = ": render with `rtlang SCENE -o picture.png`";
constexpr double key_degrees = 5, drag_degrees = 180; ///< a press of an arrow; a drag across the whole window
constexpr double key_share = 0.05;                    ///< of the picture's width
constexpr double zoom_step = 0.9;
constexpr int click_pixels = 4; ///< a press that moves no farther is a click

[[noreturn]] void fail(std::string_view what) {
  throw NoWindow(fmt::format("{} ({}){}", what, SDL_GetError(), instead));
}

/// SDL's own state, and what belongs to the window.
class Screen {
public:
  Screen(const std::string& title, scene::Resolution size) {
    SDL_SetMainReady();
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no display is available");
    const std::string_view driver = SDL_GetCurrentVideoDriver();
    if (driver == "offscreen" || driver == "dummy") {
      SDL_Quit();
      throw NoWindow(fmt::format("no display is available{}", instead));
    }
    wake_ = SDL_RegisterEvents(1);
    SDL_Rect room{0, 0, size[0], size[1]};
    SDL_GetDisplayUsableBounds(0, &room);
    const double fit = std::min({1.0, 0.9 * room.w / size[0], 0.9 * room.h / size[1]});
    window_ = SDL_CreateWindow(
        title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, std::max(64, static_cast<int>(size[0] * fit)),
        std::max(64, static_cast<int>(size[1] * fit)), SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    if (window_) renderer_ = SDL_CreateRenderer(window_, -1, 0);
    if (!renderer_) close(), fail("no window can be opened");
  }
  ~Screen() { close(); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// In pixels, of which a high-density display has more than its coordinates indicate.
  scene::Resolution size() const {
    scene::Resolution size{1, 1};
    SDL_GetRendererOutputSize(renderer_, &size[0], &size[1]);
    return size;
  }
  /// How many pixels one unit of a mouse coordinate is.
  double density() const {
    int width = 1;
    SDL_GetWindowSize(window_, &width, nullptr);
    return static_cast<double>(size()[0]) / std::max(1, width);
  }
  void set_title(const std::string& title) { SDL_SetWindowTitle(window_, title.c_str()); }

  void draw(const Pixels& pixels) {
    if (!texture_ || pixels.width != texture_width_ || pixels.height != texture_height_) {
      SDL_DestroyTexture(texture_);
      texture_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STREAMING, pixels.width,
                                   pixels.height);
      if (!texture_) fail("cannot create the window's texture");
      texture_width_ = pixels.width;
      texture_height_ = pixels.height;
    }
    SDL_UpdateTexture(texture_, nullptr, pixels.argb.data(), pixels.width * 4);
    present();
  }
  void present() {
    SDL_RenderClear(renderer_);
    if (texture_) SDL_RenderCopy(renderer_, texture_, nullptr, nullptr);
    SDL_RenderPresent(renderer_);
  }

  /// Ends a wait for events; from any thread.
  void wake() const {
    SDL_Event event{};
    event.type = wake_;
    SDL_PushEvent(&event);
  }

private:
  void close() {
    if (texture_) SDL_DestroyTexture(texture_);
    if (renderer_) SDL_DestroyRenderer(renderer_);
    if (window_) SDL_DestroyWindow(window_);
    SDL_Quit();
  }

  SDL_Window* window_ = nullptr;
  SDL_Renderer* renderer_ = nullptr;
  SDL_Texture* texture_ = nullptr;
  int texture_width_ = 0, texture_height_ = 0;
  std::uint32_t wake_ = 0;
};

std::vector<std::filesystem::path> files_of(const live::Document& document) {
  std::vector<std::filesystem::path> files;
  for (lang::FileId id = 0; id < document.sources().size(); ++id)
    if (const std::string& path = document.sources().file(id).path; !path.empty()) files.emplace_back(path);
  return files;
}

/// One window, from its opening to its end.
class Session {
public:
  Session(std::unique_ptr<live::Document> document, const WindowHost& host)
      : host_(host), screen_(host.name, document->scene().size), viewer_([this] { screen_.wake(); }) {
    watch_.follow(files_of(*document));
    viewer_.resize(screen_.size());
    viewer_.show(std::move(document));
  }

  void run() {
    while (!is_over_) {
      viewer_.refresh();
      SDL_Event event;
      for (int is_there = SDL_WaitEventTimeout(&event, 50); is_there; is_there = SDL_PollEvent(&event)) handle(event);
      if (host_.stop && *host_.stop) return;
      if (watch_.has_changed()) reload();
      if (viewer_.take(pixels_)) screen_.draw(pixels_);
      show_title();
    }
  }

private:
  void reload() {
    std::unique_ptr<live::Document> document = host_.load();
    watch_.follow(files_of(*document));
    is_wrong_ = !document->has_scene();
    if (!is_wrong_) viewer_.show(std::move(document)); // else the last good picture stays
  }

  void show_title() {
    const double fraction = viewer_.fraction();
    std::string title = host_.name;
    if (is_wrong_)
      title += " (the scene has errors)";
    else if (fraction < 1)
      title += fmt::format(" ({} %)", static_cast<int>(fraction * 100));
    if (title == title_) return;
    title_ = title;
    screen_.set_title(title);
  }

  void handle(const SDL_Event& event) {
    switch (event.type) {
    case SDL_QUIT:
      is_over_ = true;
      break;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) viewer_.resize(screen_.size());
      if (event.window.event == SDL_WINDOWEVENT_EXPOSED) screen_.present();
      break;
    case SDL_KEYDOWN:
      press(event.key.keysym);
      break;
    case SDL_MOUSEWHEEL:
      viewer_.move(zoomed(viewer_.camera(), std::pow(zoom_step, event.wheel.preciseY)));
      break;
    case SDL_MOUSEBUTTONDOWN:
      pressed_x_ = event.button.x;
      pressed_y_ = event.button.y;
      is_drag_ = false;
      break;
    case SDL_MOUSEBUTTONUP:
      if (event.button.button == SDL_BUTTON_LEFT && !is_drag_) probe();
      break;
    case SDL_MOUSEMOTION:
      drag(event.motion);
      break;
    default:
      break;
    }
  }

  void drag(const SDL_MouseMotionEvent& motion) {
    if (motion.state == 0) return;
    const int far = std::max(std::abs(motion.x - pressed_x_), std::abs(motion.y - pressed_y_));
    is_drag_ = is_drag_ || far >= click_pixels;
    if (!is_drag_) return;
    const double width = screen_.size()[0] / screen_.density(); // what is seen follows the pointer
    const double right = -motion.xrel / width, up = motion.yrel / width;
    viewer_.move((motion.state & SDL_BUTTON_LMASK) != 0
                     ? orbited(viewer_.camera(), right * drag_degrees, up * drag_degrees)
                     : panned(viewer_.camera(), right, up));
  }

  void press(const SDL_Keysym& key) {
    const bool pans = (key.mod & KMOD_SHIFT) != 0;
    const auto step = [&](double right, double up) {
      viewer_.move(pans ? panned(viewer_.camera(), right * key_share, up * key_share)
                        : orbited(viewer_.camera(), right * key_degrees, up * key_degrees));
    };
    switch (key.sym) {
    case SDLK_ESCAPE:
    case SDLK_q:
      is_over_ = true;
      break;
    case SDLK_LEFT:
      return step(-1, 0);
    case SDLK_RIGHT:
      return step(1, 0);
    case SDLK_UP:
      return step(0, 1);
    case SDLK_DOWN:
      return step(0, -1);
    case SDLK_PLUS:
    case SDLK_EQUALS:
    case SDLK_KP_PLUS:
      return viewer_.move(zoomed(viewer_.camera(), zoom_step));
    case SDLK_MINUS:
    case SDLK_KP_MINUS:
      return viewer_.move(zoomed(viewer_.camera(), 1 / zoom_step));
    case SDLK_r:
    case SDLK_HOME:
      return viewer_.reset_camera();
    case SDLK_c:
      return host_.tell(camera_text(viewer_.camera()) + "\n");
    case SDLK_p:
      return probe();
    case SDLK_w:
      return ask([this](double x, double y) { return viewer_.why(x, y); });
    case SDLK_s:
      return save();
    case SDLK_h:
      return host_.tell(std::string(window_help()));
    default:
      break;
    }
  }

  void probe() {
    ask([this](double x, double y) { return viewer_.probe(x, y); });
  }

  /// Prints the answer about the pixel under the pointer.
  template <class Answer>
  void ask(Answer&& answer) {
    int x = 0, y = 0;
    SDL_GetMouseState(&x, &y);
    const double density = screen_.density();
    host_.tell(answer(std::floor(x * density) + 0.5, std::floor(y * density) + 0.5));
  }

  void save() {
    const std::optional<Film> film = viewer_.film();
    host_.tell(film ? fmt::format("saved {}\n", host_.save(*film)) : "the picture is not finished yet\n");
  }

  const WindowHost& host_;
  Screen screen_;
  Viewer viewer_;
  FileWatch watch_;
  Pixels pixels_;
  std::string title_;
  int pressed_x_ = 0, pressed_y_ = 0;
  bool is_drag_ = false, is_wrong_ = false, is_over_ = false;
};

} // namespace

void show_window(std::unique_ptr<live::Document> document, const WindowHost& host) {
  Session(std::move(document), host).run();
}

} // namespace rt::tools::preview
