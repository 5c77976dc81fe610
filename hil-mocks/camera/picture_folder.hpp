// Picture source: the image files of a folder in turn.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "hil-mocks/camera/picture.hpp"

namespace darwinop::hil {

// Errors of readPicture().
inline constexpr const char* kNotRegularFile = "not a regular file";
inline constexpr const char* kSavePngAgain = "save it as PNG again";

/// PNG, or binary PPM (P6) with maximum value 255. Throws std::runtime_error with a remedy.
PaintedPicture readPicture(const std::filesystem::path& file);

/// Sorted by name, each for a number of frames, then from the first again. Read once, at construction.
class PictureFolder {
 public:
  PictureFolder(const std::filesystem::path& folder, std::uint32_t frames_each);
  /// Scales to the size of `onto` by nearest neighbour.
  void draw(PaintedPicture& onto, std::uint32_t frame) const;
  [[nodiscard]] std::size_t count() const { return pictures_.size(); }

 private:
  std::uint32_t frames_each_;
  std::vector<PaintedPicture> pictures_;
};

}  // namespace darwinop::hil
