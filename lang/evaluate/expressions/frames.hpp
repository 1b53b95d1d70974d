#pragma once

#include "lang/values/thing.hpp"
#include "lang/values/value.hpp"

#include <vector>

namespace rt::lang {

/// Frees frames that are kept alive by cycles through what they contain: functions, and things of defs.
class Frames {
public:
  Frames() = default;
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;
  ~Frames();

  /// A frame that lives as long as this object.
  Ref<Frame> keep(Ref<Frame> frame);
  /// A scope ends.
  void leave(Ref<Frame> frame);

private:
  std::vector<Ref<Frame>> suspects_;              // that may be in a cycle
  std::size_t next_sweep_ = std::size_t{1} << 14; // how many of them trigger the next sweep
};

/// Releases a frame at the end of a scope, even if the evaluation ends in the middle of it.
class FrameScope {
public:
  FrameScope(Frames& frames, Ref<Frame> frame) : frames_(frames), frame_(std::move(frame)) {}
  FrameScope(const FrameScope&) = delete;
  FrameScope& operator=(const FrameScope&) = delete;
  ~FrameScope() { frames_.leave(std::move(frame_)); }
  Frame* get() const { return frame_.get(); }

private:
  Frames& frames_;
  Ref<Frame> frame_;
};

} // namespace rt::lang
