// The robot's camera for onlookers: opened while somebody looks and nobody drives, let go at once when somebody does.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "remote/picture_source.hpp"

namespace darwinop::monitor {

class Eye {
 public:
  /// Opens the camera. Throws std::runtime_error when there is none. An empty function: there is none.
  using Open = std::function<std::unique_ptr<remote::PictureSource>()>;
  static constexpr Nanos kAgain{5'000'000'000};  // after it could not be opened

  explicit Eye(Open open) : open_{std::move(open)} {}

  /// `wanted`: somebody asks for pictures. `free`: nobody drives; who drives may want the camera.
  void look(bool wanted, bool free, Nanos now);

  /// `sequence` 0: there is none, see why().
  [[nodiscard]] remote::JpegPicture newest();
  /// Why there are no pictures; empty when the camera is open.
  [[nodiscard]] const std::string& why() const { return why_; }
  [[nodiscard]] bool open() const { return pictures_ != nullptr; }

 private:
  Open open_;
  std::unique_ptr<remote::PictureSource> pictures_;
  std::string why_ = "nobody has asked for pictures";
  Nanos next_try_{0};
};

}  // namespace darwinop::monitor
