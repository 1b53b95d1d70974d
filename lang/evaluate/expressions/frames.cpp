#include "lang/evaluate/expressions/frames.hpp"

#include <algorithm>

namespace rt::lang {

// The contents of frames may refer to them in turn, through functions and the things of defs.
Frames::~Frames() {
  for (const Ref<Frame>& frame : suspects_) frame->clear();
}

Ref<Frame> Frames::keep(Ref<Frame> frame) {
  return suspects_.emplace_back(std::move(frame));
}

// A frame to which its own values refer would never be freed: a function stored in it, or a thing made by a def in it.
void Frames::leave(Ref<Frame> frame) {
  if (frame->references == 1) return;
  std::uint32_t own = 1;
  bool may_hold_itself = false;
  for (std::uint32_t i = 0; i < frame->size; ++i) {
    const Value& value = (*frame)[i];
    if (!value.is_shared() || value.is(ValueKind::string)) continue;
    may_hold_itself = true;
    if (value.cell()->references != 1) continue;
    if (value.is(ValueKind::closure) && value.closure().parent == frame) ++own;
    if (value.is(ValueKind::thing) && value.thing().def_frame == frame) ++own;
  }
  if (frame->references == own)
    frame->clear();
  else if (may_hold_itself)
    suspects_.push_back(std::move(frame));
  if (suspects_.size() < next_sweep_) return;
  std::erase_if(suspects_, [](const Ref<Frame>& f) { return f->references == 1; });
  next_sweep_ = std::max(next_sweep_, 2 * suspects_.size()); // so that many survivors are not scanned again and again
}

} // namespace rt::lang
