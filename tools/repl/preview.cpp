#include "tools/repl/preview.hpp"

#include <fmt/format.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace rt::tools {

Preview::Preview(const PicturePrinter& printer) : printer_(printer), wake_fd_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (wake_fd_ < 0) throw std::system_error(errno, std::generic_category(), "cannot make an event descriptor");
}

Preview::~Preview() {
  cancel();
  close(wake_fd_);
}

void Preview::start(const PictureExtent& extent, MakeFilm make_film) {
  cancel();
  stop_ = false;
  worker_ = std::thread([this, extent, make = std::move(make_film)] { work(extent, make); });
}

void Preview::cancel() {
  stop_ = true;
  if (worker_.joinable()) worker_.join();
  const std::lock_guard lock(mutex_);
  ready_.clear();
  shown_rows_ = 0;
  drain();
}

void Preview::work(const PictureExtent& extent, const MakeFilm& make_film) {
  constexpr std::array<int, 2> coarseness{4, 1};
  for (const int by : coarseness) {
    const scene::Resolution size{std::max(1, extent.width / by), std::max(1, extent.height / by)};
    std::optional<Film> film;
    try {
      film = make_film(size, stop_);
    } catch (const std::exception&) {
      return; // the command that shows the picture will say why it cannot
    }
    if (!film || stop_) return;
    std::string picture = printer_.print(*film, extent);
    const std::lock_guard lock(mutex_);
    ready_ = std::move(picture);
    ready_rows_ = extent.rows;
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t n = write(wake_fd_, &one, sizeof one);
  }
}

void Preview::drain() const {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t n = read(wake_fd_, &count, sizeof count);
}

std::string Preview::take() {
  const std::lock_guard lock(mutex_);
  drain();
  if (ready_.empty()) return "";
  std::string text = shown_rows_ > 0 ? fmt::format("\x1b[{}A\r\x1b[J", shown_rows_) : "";
  text += std::exchange(ready_, "");
  shown_rows_ = ready_rows_;
  return text;
}

} // namespace rt::tools
