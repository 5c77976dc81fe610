// Capture thread: open, stream, report errors, wait, reopen.
#pragma once

#include <memory>
#include <string>

#include "hal/camera_v4l2/camera.hpp"
#include "hal/camera_v4l2/device.hpp"
#include "hal/camera_v4l2/frame_count.hpp"
#include "hal/camera_v4l2/picture.hpp"
#include "hal/camera_v4l2/reporter.hpp"
#include "hal/camera_v4l2/wake.hpp"
#include "hal/triple_buffer.hpp"

namespace darwinop::v4l2 {

class StreamBuffers;
class PictureTaker;

class Capture {
 public:
  explicit Capture(CameraOptions options);
  ~Capture() = default;
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  /// Thread function; returns after stop().
  void run() noexcept;

  /// Any other thread.
  void stop() noexcept { wake_.stop(); }
  /// After stop(), if run() has not returned and the owner leaves: disables messages.
  void leaveBehind();

  /// User's thread. Wait-free.
  CameraFrame newest() noexcept;
  [[nodiscard]] CameraHealth health() const noexcept;

 private:
  struct Ending {
    CameraError kind = CameraError::kOther;
    std::string detail;
  };
  bool attempt();
  bool session();
  [[nodiscard]] PictureShape agree(const V4l2Device& device);
  Ending watch(const V4l2Device& device, PictureTaker& taker);
  static Ending lost(int error);
  void report(CameraError kind, const std::string& sentence);

  CameraOptions options_;
  Wake wake_;
  Reporter reporter_;
  Counters counters_;
  FrameCount count_;
  bool streamed_ = false;
  Size fixed_{};  // after the first start of streaming

  Picture black_;                                    // returned until there are pictures
  std::unique_ptr<TripleBuffer<Picture>> pictures_;  // allocated once, by the thread
  std::atomic<TripleBuffer<Picture>*> shown_{nullptr};
};

}  // namespace darwinop::v4l2
