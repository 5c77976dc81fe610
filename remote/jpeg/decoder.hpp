// Decodes JPEG pictures received over the network to BGRA.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "remote/jpeg/image_size.hpp"

namespace darwinop::remote {

/// Size according to the file's header; nullopt if it is not a JPEG or not a size of image_size.hpp.
[[nodiscard]] std::optional<ImageSize> imageSizeOf(std::span<const std::uint8_t> jpeg);

inline constexpr const char* kEmptyJpeg = "empty";
inline constexpr const char* kInvalidJpeg = "not a JPEG, or damaged";
inline constexpr const char* kUnexpectedSize = "unexpected size";

/// `bgra`: 4 * width * height bytes of `expected`; A is 255. Returns null, or the reason for the failure; `bgra` may
/// have been written to by then. The input is untrusted: a picture of another size allocates nothing, and multiple
/// scans, whose decoding time is unbounded, are refused.
[[nodiscard]] const char* decodeJpeg(std::span<const std::uint8_t> jpeg, ImageSize expected,
                                     std::span<std::uint8_t> bgra);

}  // namespace darwinop::remote
