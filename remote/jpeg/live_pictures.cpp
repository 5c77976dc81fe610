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

/// The thread may be started by a real-time one; pictures must not delay the loop.
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
    do look();
    while (!stoppedWithin(options.look_every));
  }
  void look() noexcept;
  void complain(const CameraFrame& frame) noexcept;
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
  std::uint64_t last = 0;  // the thread's
  bool usable = true;      // the thread's: frames of kWholeImage
  std::atomic<bool> sees{false};
  std::mutex mutex;
  std::condition_variable changed;
  bool stopping = false;
  std::thread thread;
};

void LivePictures::Work::look() noexcept {
  const bool seeing = camera->health().seeing;  // asked first: true of the frame, or of an older one
  const CameraFrame frame = camera->newest();
  if (frame.sequence != std::exchange(last, frame.sequence)) {
    File& file = files.back();
    file.length = encoder.encode(frame, file.bytes);
    file.sequence = frame.sequence;
    file.time = frame.time;
    if (file.length != 0) {
      if (options.look_at) options.look_at(frame);
      files.publish();
    } else if (std::exchange(usable, false)) {
      complain(frame);
    }
  }
  sees.store(usable && seeing, std::memory_order_release);
}

void LivePictures::Work::complain(const CameraFrame& frame) noexcept {
  if (!options.say) return;
  try {
    options.say("the camera's pictures are " + std::to_string(frame.width) + "x" + std::to_string(frame.height) +
                ", those of remote control are cut out of 320x240: clients see black; use a camera that has this size");
  } catch (...) {  // no memory for the words
  }
}

LivePictures::LivePictures(std::unique_ptr<FrameSource> camera, Options options)
    : work_{std::make_unique<Work>(std::move(camera), std::move(options))} {
  sigset_t all, before;
  ::sigfillset(&all);
  // What the thread does wrong itself still ends the process as it should.
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigdelset(&all, own);
  ::pthread_sigmask(SIG_BLOCK, &all, &before);  // inherited by the new thread: signals are for the main one
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
  // An old picture would be followed as if it were the world.
  if (file.sequence == 0 || !work.sees.load(std::memory_order_acquire)) return {0, Nanos{0}, work.black};
  return {file.sequence, work.options.now() - file.time, std::span{file.bytes}.first(file.length)};
}

}  // namespace darwinop::remote
