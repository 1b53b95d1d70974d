#pragma once

#include "tools/live/document.hpp"
#include "tools/live/preview.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace rt::tools::preview {

/// A picture for a screen: 0xffRRGGBB, row by row from the top left.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint32_t> argb;
};

/// A scene as a window shows it: its picture as it is rendered, coarse at first, from a movable camera, and answers
/// about its points. It knows no window. Called from one thread; the picture is rendered in others.
class Viewer {
public:
  /// `on_change` is called, from any thread, when `take` has something new.
  explicit Viewer(std::function<void()> on_change) : on_change_(std::move(on_change)) {}
  ~Viewer() { preview_.cancel(); }
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Shows this document from now on; it must have a scene. A camera that was moved by hand stays, unless the scene's
  /// own has changed.
  void show(std::unique_ptr<live::Document> document);
  /// The size of the picture, whatever the scene says; each side at least 1.
  void resize(scene::Resolution size);
  const scene::Camera& camera() const { return camera_; }
  void move(const scene::Camera& camera);
  /// Returns to the scene's own camera.
  void reset_camera();

  /// Restarts the picture if the view has changed. During continuous movement, each picture gets as far as its coarse
  /// version.
  void refresh();
  /// The newest picture, if it differs from the last one taken.
  bool take(Pixels& pixels);
  /// Of the picture being rendered, 0 to 1; 1 when it is complete.
  double fraction() const;
  /// The complete picture, once it is finished.
  std::optional<Film> film() const;

  /// What `rtlang probe` and `rtlang why` say about a point of the picture, in pixels from its top left
  /// corner.
  std::string probe(double x, double y);
  std::string why(double x, double y);

private:
  void start();
  explain::Question question(double x, double y) const;
  void publish(const Film& film, const PixelRect& part, bool is_last);

  std::function<void()> on_change_;
  std::unique_ptr<live::Document> document_;
  scene::Camera camera_;
  scene::Resolution size_{1, 1};
  bool is_stale_ = false; ///< the view has changed

  mutable std::mutex mutex_; // guards what follows
  Pixels pixels_;
  bool is_new_ = false;
  bool has_coarse_ = true; ///< of the picture being rendered
  double fraction_ = 0;
  std::optional<Film> film_;

  live::Preview preview_; // last: its thread uses the rest
};

} // namespace rt::tools::preview
