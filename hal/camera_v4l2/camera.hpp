// The robot's camera: a thread captures pictures from a V4L2 device and keeps the newest one ready.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "hal/frame_source.hpp"
#include "hal/pixels/yuyv_image.hpp"

namespace darwinop::v4l2 {

/// Camera controls. Defaults: those of the robot's software of 2013 (ref: framework's camera settings).
struct CameraSettings {
  static constexpr int kDriversDefault = -1;
  int brightness = kDriversDefault, contrast = kDriversDefault, saturation = kDriversDefault;  // 0..255
  int gain = 255;                                                                              // 0..255
  int exposure = 1000;  // 0..10000, units of 100 us
  bool auto_exposure = false, auto_white_balance = false, auto_gain = false, auto_hue = false;
};

/// Time limits. Tests use shorter ones.
struct CameraPatience {
  Nanos silent = std::chrono::seconds{2};              // without a complete picture; the device is then reopened
  Nanos first_pause = std::chrono::milliseconds{500};  // before the device is reopened; doubles
  Nanos longest_pause = std::chrono::seconds{5};
  // Wait for the thread in the destructor; after it the thread is abandoned.
  Nanos grace = std::chrono::milliseconds{100};
};

/// Called for each shown picture, in camera format, from the camera's thread; `time` is CLOCK_MONOTONIC. Must not throw
/// or block, must not keep the bytes, and must own what it uses: it lives as long as that thread.
using RawFrameTaker = std::function<void(const pixels::YuyvImage& image, std::uint64_t sequence, Nanos time)>;

struct CameraOptions {
  std::string device = "/dev/video0";
  int width = 320, height = 240;  // an unsupported size becomes 320x240, with a message
  CameraSettings settings{};
  PictureForm form = PictureForm::kBgra;
  /// Called with a message when the camera is lost, is back, or rejects a setting; from the camera's thread. It must
  /// not wait for the thread that destroys the camera.
  std::function<void(const std::string&)> log;
  RawFrameTaker on_raw_frame = {};
  CameraPatience patience{};
};

/// newest() and health() are wait-free. A camera that is absent, unplugged or silent is not an error: `log` receives
/// one message, and the device is retried with growing pauses.
class Camera final : public FrameSource {
 public:
  /// Throws std::system_error only if the process has no files or threads left.
  explicit Camera(CameraOptions options);
  ~Camera() override;  // within 0.2 s (`grace` plus overhead); no message is sent after it
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  /// Before the first picture: black, `sequence` 0, in the requested size. The size is fixed when the device is first
  /// opened; a camera that returns with another size is not used.
  CameraFrame newest() override;
  [[nodiscard]] CameraHealth health() const override;

 private:
  struct Work;
  Nanos grace_;
  std::shared_ptr<Work> work_;
  std::thread thread_;
};

}  // namespace darwinop::v4l2
