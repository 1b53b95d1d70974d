#include "tools/live/preview.hpp"

#include <algorithm>
#include <exception>
#include <utility>

namespace rt::tools::live {

void Preview::start(scene::Resolution size, MakeFilm make_film, Show show) {
  cancel();
  stop_ = false;
  worker_ = std::thread([this, size, make = std::move(make_film), show = std::move(show)] { work(size, make, show); });
}

void Preview::cancel() {
  stop_ = true;
  if (worker_.joinable()) worker_.join();
}

void Preview::work(scene::Resolution size, const MakeFilm& make_film, const Show& show) const {
  for (const int coarseness : {4, 1}) {
    try {
      const auto film = make_film({std::max(1, size[0] / coarseness), std::max(1, size[1] / coarseness)}, stop_);
      if (!film || stop_) return;
      show(*film);
    } catch (const std::exception&) {
      return; // whoever requests the picture itself gets the error
    }
  }
}

} // namespace rt::tools::live
