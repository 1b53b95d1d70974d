#pragma once

#include "tools/live/document.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace rt::tools::preview {

/// There is no screen to open a window on, or this build has no windows; the message says what to do instead.
struct NoWindow : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a window needs from its owner.
struct WindowHost {
  std::string name; ///< of the scene, for the title
  /// Reloads the scene and reports its errors; a document without a scene if there are any.
  std::function<std::unique_ptr<live::Document>()> load;
  std::function<void(const std::string& text)> tell; ///< prints answers
  std::function<std::string(const Film& film)> save; ///< writes the picture; returns its file name
  const std::atomic<bool>* stop = nullptr;           ///< set from outside: the window closes
};

/// Shows the document, which must have a scene, until the window is closed. Throws NoWindow.
void show_window(std::unique_ptr<live::Document> document, const WindowHost& host);

/// The keys and their functions, a line each.
std::string_view window_help();

} // namespace rt::tools::preview
