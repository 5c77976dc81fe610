// The pictures of a folder, one after the other: what the camera of a real robot saw, or what one drew.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "hil-mocks/camera/picture.hpp"

namespace darwinop::hil {

/// PNG, or binary PPM (P6) with 255 as its greatest value. Throws std::runtime_error with what to do.
Picture readPicture(const std::filesystem::path& file);

/// In the order of their names, each for so many frames, then again from the first. Read once, at the beginning.
class PictureFolder {
 public:
  PictureFolder(const std::filesystem::path& folder, std::uint32_t frames_each);
  /// Scaled to the size of `onto`: each pixel is the nearest one's colour.
  void draw(Picture& onto, std::uint32_t frame) const;
  [[nodiscard]] std::size_t count() const { return pictures_.size(); }

 private:
  std::uint32_t frames_each_;
  std::vector<Picture> pictures_;
};

}  // namespace darwinop::hil
