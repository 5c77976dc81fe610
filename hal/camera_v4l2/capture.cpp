// The camera's thread.
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

/// What can be asked for at all: pixels come in pairs, and some sizes would take all memory.
Size askable(const CameraOptions& options) {
  constexpr int kMost = 4096;
  const bool good = options.width >= 2 && options.width <= kMost && options.width % 2 == 0 && options.height >= 1 &&
                    options.height <= kMost;
  return good ? Size{options.width, options.height} : kFallback;
}

// How many of this process are left behind. Their devices are not told apart: a robot has one camera.
constinit std::atomic<int> left_behind{0};

}  // namespace

Capture::Capture(CameraOptions options)
    : options_{std::move(options)}, voice_{options_.say}, black_{blackPicture(askable(options_), options_.form)} {}

Capture::~Capture() {
  if (left_behind_) left_behind.fetch_sub(1);
}

void Capture::leaveBehind() {
  voice_.mute();  // whoever listens may be gone soon
  left_behind_ = true;
  left_behind.fetch_add(1);
}

void Capture::run() noexcept {
  const CameraPatience& patience = options_.patience;
  Nanos pause = patience.first_pause;
  while (!wake_.stopped()) {
    const Nanos begun = monotonicNow();
    bool saw = false;
    try {
      saw = attempt();
    } catch (...) {  // no memory even for the words
    }
    // A camera that comes and goes every second is left alone for longer and longer.
    if (saw && monotonicNow() - begun > patience.longest_pause) pause = patience.first_pause;
    wake_.wait(-1, pause);
    pause = std::min(2 * pause, patience.longest_pause);
  }
}

bool Capture::attempt() {
  // A predecessor whose driver does not return keeps the device busy: no other program is to blame, yet.
  constexpr std::chrono::seconds kHandOver{1};
  constexpr std::chrono::milliseconds kLookAgain{20};
  const Nanos quiet_until = monotonicNow() + kHandOver;
  for (;;) {
    const bool has_predecessor = left_behind.load() != 0;  // asked first: it may let go while we are refused
    try {
      return session();
    } catch (const CameraRefused& refused) {
      if (refused.trouble() != Trouble::kBusy || !has_predecessor || monotonicNow() >= quiet_until) {
        tell(refused.trouble(), refused.what());
        return false;
      }
    } catch (const std::bad_alloc&) {
      tell(Trouble::kOutOfMemory, explain(Trouble::kOutOfMemory, options_.device));
      return false;
    }
    if (wake_.wait(-1, kLookAgain) == Wake::Why::kStop) return false;
  }
}

/// From opening to losing it. True: pictures came.
bool Capture::session() {
  const Device device{options_.device};
  const PictureShape shape = agree(device);
  applySettings(device, options_.settings, [this](const std::string& sentence) { voice_.remark(sentence); });
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
  if (!wake_.stopped()) tell(ending.trouble, explain(ending.trouble, options_.device, ending.detail));
  return counters_.frames.load(std::memory_order_relaxed) != before;
}

PictureShape Capture::agree(const Device& device) {
  if (!streamed_)
    return negotiate(device, askable(options_), [this](const std::string& sentence) { voice_.remark(sentence); });
  // Whoever looks at the pictures knows their size by now.
  const PictureShape shape = negotiate(device, fixed_, [](const std::string&) {});
  if (shape.size != fixed_)
    throw CameraRefused{Trouble::kOtherSize, options_.device, text(shape.size) + " instead of " + text(fixed_)};
  return shape;
}

Capture::Ending Capture::watch(const Device& device, PictureTaker& taker) {
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
      if (voice_.troubled()) voice_.back("the camera at " + options_.device + " is back");
    }
    if (outcome.error != 0) return lost(outcome.error);
    if (why == Wake::Why::kTroubled && outcome.idle) return lost(ENODEV);
    if (monotonicNow() - last >= silent)
      return {
          counters_.damaged.load(std::memory_order_relaxed) != damaged_before ? Trouble::kDamaged : Trouble::kSilent,
          {}};
    // A driver that says "ready" and has nothing must not keep a CPU busy.
    if (outcome.idle) wake_.wait(-1, std::chrono::milliseconds{5});
  }
}

Capture::Ending Capture::lost(int error) {
  const Trouble trouble = troubleOf(error);
  if (trouble == Trouble::kAbsent) return {Trouble::kUnplugged, {}};
  return {trouble == Trouble::kReadErrors ? trouble : Trouble::kOther, std::strerror(error)};
}

void Capture::tell(Trouble trouble, const std::string& sentence) {
  voice_.trouble(trouble, sentence + "; it is tried again until it works");
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
