// What the camera's thread does all its life: open, take pictures, tell what is wrong, pause, open again.
#pragma once

#include <memory>
#include <string>

#include "hal/camera_v4l2/camera.hpp"
#include "hal/camera_v4l2/device.hpp"
#include "hal/camera_v4l2/frame_count.hpp"
#include "hal/camera_v4l2/picture.hpp"
#include "hal/camera_v4l2/voice.hpp"
#include "hal/camera_v4l2/wake.hpp"
#include "hal/triple_buffer.hpp"

namespace darwinop::v4l2 {

class StreamBuffers;
class PictureTaker;

class Capture {
 public:
  explicit Capture(CameraOptions options);
  ~Capture();
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  /// The thread: until stop(). Nothing is thrown out of it.
  void run() noexcept;

  /// Any other thread.
  void stop() noexcept { wake_.stop(); }
  /// After stop(), by an owner who leaves although run() has not returned: nothing is said after it, and the cameras of
  /// this process know that one of them may still have its device open.
  void leaveBehind();

  /// The user's thread. Wait-free.
  CameraFrame newest() noexcept;
  [[nodiscard]] CameraHealth health() const noexcept;

 private:
  struct Ending {
    Trouble trouble = Trouble::kOther;
    std::string detail;
  };
  bool attempt();
  bool session();
  [[nodiscard]] PictureShape agree(const Device& device);
  Ending watch(const Device& device, PictureTaker& taker);
  static Ending lost(int error);
  void tell(Trouble trouble, const std::string& sentence);

  CameraOptions options_;
  Wake wake_;
  Voice voice_;
  Counters counters_;
  FrameCount count_;
  bool left_behind_ = false;  // its owner's alone
  bool streamed_ = false;
  Size fixed_{};  // once it has streamed

  Picture black_;                                    // the user's, until there are pictures
  std::unique_ptr<TripleBuffer<Picture>> pictures_;  // made by the thread, once
  std::atomic<TripleBuffer<Picture>*> shown_{nullptr};
};

}  // namespace darwinop::v4l2
