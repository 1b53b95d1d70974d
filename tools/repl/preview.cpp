#include "tools/repl/preview.hpp"

#include <fmt/format.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace rt::tools {

PreviewPrinter::PreviewPrinter(const PicturePrinter& printer)
    : printer_(printer), wake_fd_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (wake_fd_ < 0) throw std::system_error(errno, std::generic_category(), "cannot make an event descriptor");
}

PreviewPrinter::~PreviewPrinter() {
  cancel();
  close(wake_fd_);
}

void PreviewPrinter::start(const PictureExtent& extent, live::Preview::MakeFilm make_film) {
  cancel();
  preview_.start({extent.width, extent.height}, std::move(make_film),
                 [this, extent](const Film& film) { show(extent, film); });
}

void PreviewPrinter::cancel() {
  preview_.cancel();
  const std::lock_guard lock(mutex_);
  ready_.clear();
  shown_rows_ = 0;
  drain();
}

void PreviewPrinter::show(const PictureExtent& extent, const Film& film) {
  std::string picture = printer_.print(film, extent);
  const std::lock_guard lock(mutex_);
  ready_ = std::move(picture);
  ready_rows_ = extent.rows;
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t n = ::write(wake_fd_, &one, sizeof one);
}

void PreviewPrinter::drain() const {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t n = read(wake_fd_, &count, sizeof count);
}

std::string PreviewPrinter::take() {
  const std::lock_guard lock(mutex_);
  drain();
  if (ready_.empty()) return "";
  std::string text = shown_rows_ > 0 ? fmt::format("\x1b[{}A\r\x1b[J", shown_rows_) : "";
  text += std::exchange(ready_, "");
  shown_rows_ = ready_rows_;
  return text;
}

} // namespace rt::tools
