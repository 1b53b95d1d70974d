#include "tools/preview/viewer.hpp"

#include "renderer/image/quantise.hpp"

#include <algorithm>
#include <utility>

namespace rt::tools::preview {
namespace {

bool is_same(const scene::Camera& a, const scene::Camera& b) {
  for (const scene::Field& field : fields(&a))
    if (field.get(&a) != field.get(&b)) return false;
  return true;
}

std::uint32_t argb(const Rgb32& color, const ToneCurve& curve, const SrgbQuantiser& quantise) {
  std::uint32_t code = 0xff;
  for (const float v : {color.r, color.g, color.b}) code = code << 8 | quantise(curve(v));
  return code;
}

/// When `small` pixels represent `large` ones: where the i-th begins.
int scaled(int i, int small, int large) {
  return static_cast<int>(static_cast<long long>(i) * large / small);
}

} // namespace

void Viewer::show(std::unique_ptr<live::Document> document) {
  preview_.cancel();
  const bool keeps_camera = document_ && is_same(document_->scene().camera, document->scene().camera);
  document_ = std::move(document);
  if (!keeps_camera) camera_ = document_->scene().camera;
  is_stale_ = true;
}

void Viewer::resize(scene::Resolution size) {
  size = {std::max(1, size[0]), std::max(1, size[1])};
  if (size == size_) return;
  size_ = size;
  is_stale_ = true;
}

void Viewer::move(const scene::Camera& camera) {
  if (check(camera)) return; // the camera would be invalid
  camera_ = camera;
  is_stale_ = true;
}

void Viewer::reset_camera() {
  move(document_->scene().camera);
}

void Viewer::refresh() {
  if (!is_stale_) return;
  {
    const std::lock_guard lock(mutex_);
    if (!has_coarse_) return;
  }
  start();
}

void Viewer::start() {
  preview_.cancel();
  is_stale_ = false;
  {
    const std::lock_guard lock(mutex_);
    has_coarse_ = false;
    fraction_ = 0;
    film_.reset();
    pixels_.width = size_[0];
    pixels_.height = size_[1];
    pixels_.argb.resize(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]), 0xff000000);
  }
  View view = view_of(document_->scene());
  view.camera = camera_;
  const auto make_film = [this, view](scene::Resolution size, const std::atomic<bool>& stop) -> std::optional<Film> {
    View part = view;
    part.size = size;
    RenderOptions options;
    options.stop = &stop;
    if (size != size_) {
      part.samples = 1;
      part.noise = 0;
    } else {
      options.on_tile = [this](const Film& film, const PixelRect& tile) { publish(film, tile, false); };
      options.on_progress = [this](const Progress& progress) {
        const std::lock_guard lock(mutex_);
        fraction_ = progress.fraction;
      };
    }
    Rendered rendered = document_->render(part, options);
    return rendered.is_complete ? std::optional(std::move(rendered.film)) : std::nullopt;
  };
  preview_.start(size_, make_film, [this](const Film& film) {
    publish(film, {0, 0, film.width, film.height}, film.width == size_[0] && film.height == size_[1]);
  });
}

// The pixels of a coarse film become blocks.
void Viewer::publish(const Film& film, const PixelRect& part, bool is_last) {
  static const SrgbQuantiser quantise(8);
  const ToneCurve curve(film.tone_mapping);
  {
    const std::lock_guard lock(mutex_);
    for (int y = part.y0; y < part.y1; ++y) {
      for (int x = part.x0; x < part.x1; ++x) {
        const std::uint32_t code = argb(film.color[film.index(x, y)], curve, quantise);
        const int right = scaled(x + 1, film.width, pixels_.width), bottom = scaled(y + 1, film.height, pixels_.height);
        for (int row = scaled(y, film.height, pixels_.height); row < bottom; ++row) {
          std::uint32_t* const line =
              pixels_.argb.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels_.width);
          std::fill(line + scaled(x, film.width, pixels_.width), line + right, code);
        }
      }
    }
    is_new_ = true;
    has_coarse_ = true;
    if (is_last) fraction_ = 1, film_ = film;
  }
  on_change_();
}

bool Viewer::take(Pixels& pixels) {
  const std::lock_guard lock(mutex_);
  if (!is_new_) return false;
  pixels = pixels_;
  is_new_ = false;
  return true;
}

double Viewer::fraction() const {
  const std::lock_guard lock(mutex_);
  return fraction_;
}

std::optional<Film> Viewer::film() const {
  const std::lock_guard lock(mutex_);
  return film_;
}

// From the scene's own camera it is a question about a pixel, else about a ray.
explain::Question Viewer::question(double x, double y) const {
  const bool is_own = size_ == document_->scene().size && is_same(camera_, document_->scene().camera);
  explain::Question question;
  if (is_own)
    question.pixel = {{static_cast<int>(x), static_cast<int>(y)}};
  else
    question.ray = CameraRays(camera_, size_).ray(x, y);
  return question;
}

std::string Viewer::probe(double x, double y) {
  return document_->probe(question(x, y), {});
}

std::string Viewer::why(double x, double y) {
  return document_->why(question(x, y), {});
}

} // namespace rt::tools::preview
