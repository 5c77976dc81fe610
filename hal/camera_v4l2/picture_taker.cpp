// Takes filled buffers from the driver and converts the newest complete picture.
#include "hal/camera_v4l2/picture_taker.hpp"

#include <cerrno>
#include <optional>

#include "hal/camera_v4l2/monotonic.hpp"
#include "hal/pixels/yuyv_to_bgra.hpp"

namespace darwinop::v4l2 {

PictureTaker::Outcome PictureTaker::takeAll() noexcept {
  Outcome outcome;
  std::optional<Numbered> newest;
  outcome.idle = true;
  // Bounds the loop if the driver fills buffers faster than they are read.
  for (std::uint32_t i = 0; i < buffers_.count(); ++i) {
    const Filled filled = buffers_.take();
    if (filled.error == EAGAIN) break;
    outcome.idle = false;
    if (filled.error != 0) {
      outcome.error = filled.error;
      break;
    }
    errors_.over();
    const Numbered taken = number(filled);
    std::uint32_t done = filled.index;
    if (filled.marked_bad || !isWhole(imageOf(filled))) {
      counters_.damaged.fetch_add(1, std::memory_order_relaxed);
    } else {
      counters_.frames.fetch_add(1, std::memory_order_relaxed);
      if (newest) done = newest->filled.index;
      const bool keeps_it = !newest;
      newest = taken;
      if (keeps_it) continue;
    }
    if ((outcome.error = buffers_.giveBack(done)) != 0) break;
  }
  if (newest) {
    show(*newest);
    outcome.shown = true;
    const int error = buffers_.giveBack(newest->filled.index);
    if (outcome.error == 0) outcome.error = error;
  }
  if (outcome.error == EIO) outcome.error = readError(outcome.error);
  return outcome;
}

PictureTaker::Numbered PictureTaker::number(const Filled& filled) noexcept {
  const FrameCount::Number number = count_.next(filled.sequence);
  counters_.dropped.fetch_add(number.dropped, std::memory_order_relaxed);
  return {filled, number.sequence};
}

/// A damaged picture (0), or a broken device (the errno).
int PictureTaker::readError(int error) noexcept {
  if (errors_.add(monotonicNow())) return error;
  counters_.damaged.fetch_add(1, std::memory_order_relaxed);
  count_.unnumbered();
  return buffers_.giveBackStrays();
}

pixels::YuyvImage PictureTaker::imageOf(const Filled& filled) const noexcept {
  return {filled.bytes, shape_.size.width, shape_.size.height, shape_.stride};
}

void PictureTaker::show(const Numbered& newest) noexcept {
  Picture& picture = pictures_.back();
  const pixels::YuyvImage image = imageOf(newest.filled);
  if (picture.yuyv.empty())
    pixels::yuyvToBgraRotated(image, picture.bgra);
  else
    pixels::copyWithoutGaps(image, picture.yuyv);
  picture.sequence = newest.sequence;
  picture.time = newest.filled.time;
  pictures_.publish();
  counters_.last_frame_ns.store(monotonicNow().count(), std::memory_order_release);
  if (on_raw_frame_)
    on_raw_frame_(image, newest.sequence, newest.filled.time);  // last: the controller's picture has priority
}

}  // namespace darwinop::v4l2
