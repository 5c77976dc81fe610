// Encoder thread and wait-free hand-over of pictures.
#include "remote/jpeg/live_pictures.hpp"

#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "hal/triple_buffer.hpp"
#include "remote/jpeg/black_image.hpp"
#include "remote/jpeg/encoder.hpp"

namespace darwinop::remote {
namespace {

/// The thread inherits the scheduling of a real-time thread; encoding must not delay the loop.
void becomeOrdinaryEncoder() {
  const sched_param none{};
  ::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &none);
  ::pthread_setname_np(::pthread_self(), "darwinop-jpeg");
}

}  // namespace

struct LivePictures::Work {
  struct File {
    std::uint64_t sequence = 0;
    Nanos time{0};
    std::size_t length = 0;
    std::vector<std::uint8_t> bytes;
  };

  Work(std::unique_ptr<FrameSource> source, Options given)
      : camera{std::move(source)},
        options{std::move(given)},
        encoder{options.size, options.quality},
        black{blackImage(encoder)},
        files{File{0, Nanos{0}, 0, std::vector<std::uint8_t>(encoder.mostBytes())}} {}

  void run() noexcept {
    becomeOrdinaryEncoder();
    do poll();
    while (!stoppedWithin(options.poll_interval));
  }
  void poll() noexcept;
  void reportSize(const CameraFrame& frame) noexcept;
  bool stoppedWithin(Nanos pause) noexcept {
    std::unique_lock lock{mutex};
    return changed.wait_for(lock, pause, [this] { return stopping; });
  }
  void stop() {
    const std::lock_guard lock{mutex};
    stopping = true;
    changed.notify_all();
  }

  std::unique_ptr<FrameSource> camera;
  Options options;
  JpegEncoder encoder;
  std::vector<std::uint8_t> black;
  TripleBuffer<File> files;
  std::uint64_t last = 0;  // used by the thread only
  bool usable = true;      // used by the thread only: frames have the size kWholeImage
  std::atomic<bool> sees{false};
  std::mutex mutex;
  std::condition_variable changed;
  bool stopping = false;
  std::thread thread;
};

void LivePictures::Work::poll() noexcept {
  const bool seeing = camera->health().seeing;  // read first, so that it holds for this frame or an older one
  const CameraFrame frame = camera->newest();
  if (frame.sequence != std::exchange(last, frame.sequence)) {
    File& file = files.back();
    file.length = encoder.encode(frame, file.bytes);
    file.sequence = frame.sequence;
    file.time = frame.time;
    if (file.length != 0) {
      if (options.on_frame) options.on_frame(frame);
      files.publish();
    } else if (std::exchange(usable, false)) {
      reportSize(frame);
    }
  }
  sees.store(usable && seeing, std::memory_order_release);
}

void LivePictures::Work::reportSize(const CameraFrame& frame) noexcept {
  if (!options.log) return;
  try {
    options.log("the camera's pictures have " + std::to_string(frame.width) + "x" + std::to_string(frame.height) +
                " pixels, but 320x240 is required: clients get black pictures; use a camera with this size");
  } catch (...) {  // out of memory
  }
}

LivePictures::LivePictures(std::unique_ptr<FrameSource> camera, Options options)
    : work_{std::make_unique<Work>(std::move(camera), std::move(options))} {
  sigset_t all, before;
  ::sigfillset(&all);
  // Synchronous signals stay unblocked, so that a crash in the thread ends the process.
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigdelset(&all, own);
  ::pthread_sigmask(SIG_BLOCK, &all, &before);  // inherited by the new thread: the main thread handles signals
  try {
    work_->thread = std::thread{[work = work_.get()] { work->run(); }};
  } catch (...) {
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    throw;
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

LivePictures::~LivePictures() {
  work_->stop();
  work_->thread.join();
}

JpegPicture LivePictures::newest() {
  Work& work = *work_;
  work.files.update();
  const Work::File& file = work.files.front();
  // A controller must not follow an outdated picture.
  if (file.sequence == 0 || !work.sees.load(std::memory_order_acquire)) return {0, Nanos{0}, work.black};
  return {file.sequence, work.options.now() - file.time, std::span{file.bytes}.first(file.length)};
}

}  // namespace darwinop::remote
