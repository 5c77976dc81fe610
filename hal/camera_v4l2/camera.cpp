// Public camera interface; owns the capture thread.
#include "hal/camera_v4l2/camera.hpp"

#include <pthread.h>
#include <sched.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>
#include <utility>

#include "hal/camera_v4l2/capture.hpp"

namespace darwinop::v4l2 {
namespace {

/// The creating thread may be real-time; the capture thread must not delay the loop.
void becomeOrdinaryThread() {
  const sched_param none{};
  ::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &none);
  ::pthread_setname_np(::pthread_self(), "darwinop-camera");
}

}  // namespace

/// Outlives the Camera if a driver call blocks: the call on an unplugged USB camera may take seconds.
struct Camera::Work {
  explicit Work(CameraOptions options) : capture{std::move(options)} {}

  void run() {
    becomeOrdinaryThread();
    capture.run();
    const std::lock_guard lock{mutex};
    ended = true;
    changed.notify_all();
  }
  bool endsWithin(Nanos grace) {
    std::unique_lock lock{mutex};
    return changed.wait_for(lock, grace, [this] { return ended; });
  }

  Capture capture;
  std::mutex mutex;
  std::condition_variable changed;
  bool ended = false;
};

Camera::Camera(CameraOptions options)
    : grace_{options.patience.grace}, work_{std::make_shared<Work>(std::move(options))} {
  sigset_t all, before;
  ::sigfillset(&all);
  // Synchronous signals (SIGSEGV and others) still end the process.
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigdelset(&all, own);
  ::pthread_sigmask(SIG_BLOCK, &all, &before);  // inherited by the new thread; the main thread handles signals
  try {
    thread_ = std::thread{[work = work_] { work->run(); }};
  } catch (...) {
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    throw;
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Camera::~Camera() {
  work_->capture.stop();
  if (work_->endsWithin(grace_)) {
    thread_.join();
    return;
  }
  work_->capture.leaveBehind();
  thread_.detach();
}

CameraFrame Camera::newest() {
  return work_->capture.newest();
}

CameraHealth Camera::health() const {
  return work_->capture.health();
}

}  // namespace darwinop::v4l2
