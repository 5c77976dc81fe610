// A camera's frame to a baseline JPEG.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "hal/frame_source.hpp"
#include "remote/jpeg/image_size.hpp"

namespace darwinop::remote {

/// Colours at half the resolution both ways (4:2:0), the standard's own tables: what every decoder can read. From YUYV
/// the planes go to libjpeg-turbo as they are; BGRA it converts back by itself. Used by one thread.
class JpegEncoder {
 public:
  /// Throws std::invalid_argument: no size of image_size.hpp, or a quality out of 1..100.
  JpegEncoder(ImageSize size, int quality);
  ~JpegEncoder();
  JpegEncoder(const JpegEncoder&) = delete;
  JpegEncoder& operator=(const JpegEncoder&) = delete;

  /// No file is longer.
  [[nodiscard]] std::size_t mostBytes() const noexcept;

  /// Bytes written to `into`, which is mostBytes() long at least. 0: `frame` is not of kWholeImage. Takes nothing from
  /// the heap.
  [[nodiscard]] std::size_t encode(const CameraFrame& frame, std::span<std::uint8_t> into) noexcept;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace darwinop::remote
