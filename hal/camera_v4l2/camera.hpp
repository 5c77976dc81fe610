// The robot's camera: a thread of its own takes pictures from a V4L2 device and keeps the newest one ready.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "hal/frame_source.hpp"
#include "hal/pixels/yuyv_image.hpp"

namespace darwinop::v4l2 {

/// Controls of the camera. Defaults: what the robot's software of 2013 sets (ref: framework's camera settings).
struct CameraSettings {
  static constexpr int kDriversDefault = -1;
  int brightness = kDriversDefault, contrast = kDriversDefault, saturation = kDriversDefault;  // 0..255
  int gain = 255;                                                                              // 0..255
  int exposure = 1000;  // 0..10000, units of 100 us
  bool auto_exposure = false, auto_white_balance = false, auto_gain = false, auto_hue = false;
};

/// How long to wait before something is done. Tests are in more of a hurry.
struct CameraPatience {
  Nanos silent = std::chrono::seconds{2};              // without a whole picture; then the device is opened anew
  Nanos first_pause = std::chrono::milliseconds{500};  // before it is opened again; doubles
  Nanos longest_pause = std::chrono::seconds{5};
  // For the thread at the camera's end; then it is left behind. Well within what the destructor promises.
  Nanos grace = std::chrono::milliseconds{100};
};

/// Told of each picture that is shown, as the camera gave it, from the camera's thread; `time` is CLOCK_MONOTONIC. It
/// must neither throw nor wait, keeps no bytes, and lives as long as that thread: what it uses, it owns.
using RawFrameTaker = std::function<void(const pixels::YuyvImage& image, std::uint64_t sequence, Nanos time)>;

struct CameraOptions {
  std::string device = "/dev/video0";
  int width = 320, height = 240;  // a size that the device does not give becomes 320x240, with a message
  CameraSettings settings{};
  PictureForm form = PictureForm::kBgra;
  /// Told a sentence when the camera is lost, is back, or does not do as asked; from the camera's thread. It must not
  /// wait for whoever destroys the camera.
  std::function<void(const std::string&)> say;
  RawFrameTaker on_raw_frame = {};
  CameraPatience patience{};
};

/// newest() and health() are wait-free and take no part in the camera's work. A camera that is absent, unplugged or
/// silent is no error here: `say` is told once, and it is tried again with growing pauses.
class Camera final : public FrameSource {
 public:
  /// Throws std::system_error when the process has no files or threads left, nothing else.
  explicit Camera(CameraOptions options);
  ~Camera() override;  // within 0.2 s (`grace` and a little), whatever the device does; nothing is said after it
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  /// All-black, and `sequence` 0, before the first one. Of the size that was asked for until the device was opened for
  /// the first time; then of the device's, for good: a camera that comes back with another size is not used.
  CameraFrame newest() override;
  [[nodiscard]] CameraHealth health() const override;

 private:
  struct Work;
  Nanos grace_;
  std::shared_ptr<Work> work_;
  std::thread thread_;
};

}  // namespace darwinop::v4l2
