// A picture on the channel: a small head, then a JPEG.
#pragma once

#include <cstdint>
#include <string>

#include "remote/jpeg/image_size.hpp"
#include "remote/picture_source.hpp"

namespace darwinop::monitor {

/// Little-endian: u8 kind, u8 length of the head, u16 width, u16 height, u16 0, u32 sequence, u32 age in ms, u32 0.
inline constexpr std::size_t kPictureHead = 20;
inline constexpr std::uint8_t kJpegKind = 1;

inline std::string pictureMessage(const remote::JpegPicture& picture, remote::ImageSize size) {
  std::string message;
  message.reserve(kPictureHead + picture.jpeg.size());
  const auto put = [&message](std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) message += static_cast<char>(value >> (8 * i) & 0xFF);
  };
  put(kJpegKind, 1);
  put(kPictureHead, 1);
  put(static_cast<std::uint64_t>(size.width), 2);
  put(static_cast<std::uint64_t>(size.height), 2);
  put(0, 2);
  put(picture.sequence, 4);
  put(static_cast<std::uint64_t>(picture.age / std::chrono::milliseconds{1}), 4);
  put(0, 4);
  message.append(reinterpret_cast<const char*>(picture.jpeg.data()), picture.jpeg.size());
  return message;
}

}  // namespace darwinop::monitor
