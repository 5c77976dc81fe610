// Capture thread: open, stream, report errors, wait, reopen.
#include "hal/camera_v4l2/capture.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

#include "hal/camera_v4l2/buffers.hpp"
#include "hal/camera_v4l2/controls.hpp"
#include "hal/camera_v4l2/monotonic.hpp"
#include "hal/camera_v4l2/picture_taker.hpp"

namespace darwinop::v4l2 {
namespace {

/// Requestable sizes: even width (a YUYV pair), bounded memory.
Size askable(const CameraOptions& options) {
  constexpr int kMost = 4096;
  const bool good = options.width >= 2 && options.width <= kMost && options.width % 2 == 0 && options.height >= 1 &&
                    options.height <= kMost;
  return good ? Size{options.width, options.height} : kFallback;
}

}  // namespace

Capture::Capture(CameraOptions options)
    : options_{std::move(options)}, reporter_{options_.log}, black_{blackPicture(askable(options_), options_.form)} {}

void Capture::leaveBehind() {
  reporter_.mute();  // the receiver may be destroyed soon
}

void Capture::run() noexcept {
  const CameraPatience& patience = options_.patience;
  Nanos pause = patience.first_pause;
  while (!wake_.stopped()) {
    const Nanos begun = monotonicNow();
    bool saw = false;
    try {
      saw = attempt();
    } catch (...) {  // out of memory for the message as well
    }
    // A camera that reconnects every second is retried with growing pauses.
    if (saw && monotonicNow() - begun > patience.longest_pause) pause = patience.first_pause;
    wake_.wait(-1, pause);
    pause = std::min(2 * pause, patience.longest_pause);
  }
}

bool Capture::attempt() {
  // The monitor hands the camera over to a controller that starts, and an abandoned thread of this process may keep it
  // open for a while; neither is a program to be ended.
  constexpr std::chrono::seconds kHandOver{1};
  constexpr std::chrono::milliseconds kLookAgain{20};
  const Nanos quiet_until = monotonicNow() + kHandOver;
  for (;;) {
    try {
      return session();
    } catch (const CameraRefused& refused) {
      if (refused.kind() != CameraError::kBusy || monotonicNow() >= quiet_until) {
        report(refused.kind(), refused.what());
        return false;
      }
    } catch (const std::bad_alloc&) {
      report(CameraError::kOutOfMemory, explain(CameraError::kOutOfMemory, options_.device));
      return false;
    }
    if (wake_.wait(-1, kLookAgain) == Wake::Why::kStop) return false;
  }
}

/// From opening the device until it is lost. Returns true if pictures arrived.
bool Capture::session() {
  const V4l2Device device{options_.device};
  const PictureShape shape = agree(device);
  applySettings(device, options_.settings, [this](const std::string& sentence) { reporter_.remark(sentence); });
  StreamBuffers buffers{device};
  if (!pictures_) {
    pictures_ = std::make_unique<TripleBuffer<Picture>>(blackPicture(shape.size, options_.form));
    shown_.store(pictures_.get(), std::memory_order_release);
  }
  if (std::exchange(streamed_, true)) counters_.reopened.fetch_add(1, std::memory_order_relaxed);
  fixed_ = shape.size;
  count_.restart();

  PictureTaker taker{buffers, shape, *pictures_, count_, counters_, options_.on_raw_frame};
  const std::uint64_t before = counters_.frames.load(std::memory_order_relaxed);
  const Ending ending = watch(device, taker);
  if (!wake_.stopped()) report(ending.kind, explain(ending.kind, options_.device, ending.detail));
  return counters_.frames.load(std::memory_order_relaxed) != before;
}

PictureShape Capture::agree(const V4l2Device& device) {
  if (!streamed_)
    return negotiate(device, askable(options_), [this](const std::string& sentence) { reporter_.remark(sentence); });
  // The user has allocated for this size.
  const PictureShape shape = negotiate(device, fixed_, [](const std::string&) {});
  if (shape.size != fixed_)
    throw CameraRefused{CameraError::kOtherSize, options_.device, text(shape.size) + " instead of " + text(fixed_)};
  return shape;
}

Capture::Ending Capture::watch(const V4l2Device& device, PictureTaker& taker) {
  const Nanos silent = options_.patience.silent;
  const std::uint64_t damaged_before = counters_.damaged.load(std::memory_order_relaxed);
  Nanos last = monotonicNow();
  for (;;) {
    const Wake::Why why = wake_.wait(device.fd(), last + silent - monotonicNow());
    if (why == Wake::Why::kStop) return {};
    PictureTaker::Outcome outcome;
    if (why != Wake::Why::kTimeout) outcome = taker.takeAll();
    if (outcome.shown) {
      last = monotonicNow();
      if (reporter_.hasError()) reporter_.back(explainReturn(options_.device));
    }
    if (outcome.error != 0) return lost(outcome.error);
    if (why == Wake::Why::kPollError && outcome.idle) return lost(ENODEV);
    if (monotonicNow() - last >= silent)
      return {counters_.damaged.load(std::memory_order_relaxed) != damaged_before ? CameraError::kDamaged
                                                                                  : CameraError::kSilent,
              {}};
    // A driver that polls ready without a picture must not cause a busy loop.
    if (outcome.idle) wake_.wait(-1, std::chrono::milliseconds{5});
  }
}

Capture::Ending Capture::lost(int error) {
  const CameraError kind = cameraErrorOf(error);
  if (kind == CameraError::kAbsent) return {CameraError::kUnplugged, {}};
  return {kind == CameraError::kReadErrors ? kind : CameraError::kOther, std::strerror(error)};
}

void Capture::report(CameraError kind, const std::string& sentence) {
  reporter_.report(kind, sentence + "; retrying");
}

CameraFrame Capture::newest() noexcept {
  TripleBuffer<Picture>* pictures = shown_.load(std::memory_order_acquire);
  if (pictures == nullptr) return black_.asFrame();
  pictures->update();
  return pictures->front().asFrame();
}

CameraHealth Capture::health() const noexcept {
  const auto get = [](const std::atomic<std::uint64_t>& counter) { return counter.load(std::memory_order_relaxed); };
  const Nanos last{counters_.last_frame_ns.load(std::memory_order_acquire)};
  constexpr std::chrono::seconds kSeeing{2};
  return {last.count() != 0 && monotonicNow() - last < kSeeing, get(counters_.frames), get(counters_.dropped),
          get(counters_.damaged), get(counters_.reopened)};
}

}  // namespace darwinop::v4l2
