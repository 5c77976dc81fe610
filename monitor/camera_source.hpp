// Camera of the robot for observers: the camera itself while no controller drives, otherwise the frames that the
// driving controller shares. Opened only while an observer requests pictures.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "remote/picture_source.hpp"

namespace darwinop::monitor {

class CameraSource {
 public:
  /// Opens the camera. Throws std::runtime_error if that fails. An empty function: no camera.
  using Open = std::function<std::unique_ptr<remote::PictureSource>()>;
  static constexpr const char* kNotRequested = "no observer requests pictures";
  static constexpr const char* kControllerDrives = "a controller drives and may use the camera";
  static constexpr Nanos kAgain{5'000'000'000};  // between attempts to open

  /// `share`: opens the frames that the driving controller shares, never the camera device. Empty: none are shared.
  explicit CameraSource(Open open, Open share = {}) : open_{std::move(open)}, share_{std::move(share)} {}

  /// `wanted`: an observer requests pictures. `free`: no controller drives, so the camera may be opened.
  void update(bool wanted, bool free, Nanos now);

  /// `sequence` 0: no picture, see why().
  [[nodiscard]] remote::JpegPicture newest();
  /// Why there are no pictures; empty if the camera is open and reports no error.
  [[nodiscard]] std::string why() const { return pictures_ ? pictures_->error() : why_; }
  [[nodiscard]] bool open() const { return pictures_ != nullptr; }
  /// Open are the frames that the driving controller shares.
  [[nodiscard]] bool shared() const { return open() && !free_; }

 private:
  Open open_, share_;
  bool free_ = true;
  std::unique_ptr<remote::PictureSource> pictures_;
  std::string why_ = kNotRequested;
  Nanos next_try_{0};
};

}  // namespace darwinop::monitor
