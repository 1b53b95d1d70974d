#pragma once

#include "lang/values/thing.hpp"
#include "lang/values/value.hpp"

#include <vector>

namespace rt::lang {

/// Lets go of frames that would be kept alive by what they hold themselves: functions, and things of defs.
class Frames {
public:
  Frames() = default;
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;
  ~Frames();

  /// A frame that lives as long as this does.
  Ref<Frame> keep(Ref<Frame> frame);
  /// A scope ends.
  void leave(Ref<Frame> frame);

private:
  std::vector<Ref<Frame>> suspects_;              // that may be kept alive by what they hold
  std::size_t next_sweep_ = std::size_t{1} << 14; // how many of them are looked through next
};

/// Lets go of a frame at the end of a scope, also when the evaluation ends in the middle of it.
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
