// The robot's camera for onlookers: opened while somebody looks and nobody drives, let go at once when somebody does;
// then what the driver's camera sees, if it shows that.
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

  /// `share`: opens the pictures that a driver shows; it never touches the camera. Empty: drivers show none.
  explicit Eye(Open open, Open share = {}) : open_{std::move(open)}, share_{std::move(share)} {}

  /// `wanted`: somebody asks for pictures. `free`: nobody drives; who drives may want the camera.
  void look(bool wanted, bool free, Nanos now);

  /// `sequence` 0: there is none, see why().
  [[nodiscard]] remote::JpegPicture newest();
  /// Why there are no pictures; empty when the camera is open and knows of no trouble.
  [[nodiscard]] std::string why() const { return pictures_ ? pictures_->trouble() : why_; }
  [[nodiscard]] bool open() const { return pictures_ != nullptr; }
  /// What is open is what a driver shows.
  [[nodiscard]] bool shared() const { return open() && !free_; }

 private:
  Open open_, share_;
  bool free_ = true;
  std::unique_ptr<remote::PictureSource> pictures_;
  std::string why_ = "nobody has asked for pictures";
  Nanos next_try_{0};
};

}  // namespace darwinop::monitor
