// Encodes camera frames as baseline JPEG.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "hal/frame_source.hpp"
#include "remote/jpeg/image_size.hpp"

namespace darwinop::remote {

/// 4:2:0 chroma subsampling and standard tables, which every decoder supports. YUYV planes are passed to libjpeg-turbo
/// directly; BGRA is converted by libjpeg-turbo. Not thread-safe.
class JpegEncoder {
 public:
  /// Throws std::invalid_argument: not a size of image_size.hpp, or quality outside 1..100.
  JpegEncoder(ImageSize size, int quality);
  ~JpegEncoder();
  JpegEncoder(const JpegEncoder&) = delete;
  JpegEncoder& operator=(const JpegEncoder&) = delete;

  /// Upper bound of a file's size, bytes.
  [[nodiscard]] std::size_t mostBytes() const noexcept;

  /// Bytes written to `into`, which must have at least mostBytes(). 0: `frame` does not have the size kWholeImage. Does
  /// not
  /// allocate.
  [[nodiscard]] std::size_t encode(const CameraFrame& frame, std::span<std::uint8_t> into) noexcept;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace darwinop::remote
