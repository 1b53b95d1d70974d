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

/// What a window needs of whoever opens it.
struct WindowHost {
  std::string name; ///< of the scene, for the title
  /// Reads the scene anew and tells of its mistakes; a document without a scene where there are some.
  std::function<std::unique_ptr<live::Document>()> load;
  std::function<void(const std::string& text)> tell; ///< prints answers
  std::function<std::string(const Film& film)> save; ///< writes the picture; what it was called
  const std::atomic<bool>* stop = nullptr;           ///< set from outside: the window closes
};

/// Shows the document, which must have a scene, until the window is closed. Throws NoWindow.
void show_window(std::unique_ptr<live::Document> document, const WindowHost& host);

/// The keys and what they do, a line each.
std::string_view window_help();

} // namespace rt::tools::preview
