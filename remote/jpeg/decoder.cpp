// JPEG decoder for untrusted input, with libjpeg-turbo.
#include "remote/jpeg/decoder.hpp"

#include <array>
#include <cassert>
#include <csetjmp>

#include "remote/jpeg/jpeg_errors.hpp"

namespace darwinop::remote {
namespace {

/// One per picture: otherwise libjpeg would use tables of an earlier picture for a file without tables.
struct Decompressor {
  Decompressor() {
    cinfo.err = &errors.manager;
    jpeg_create_decompress(&cinfo);
    errors.expected = true;
  }
  ~Decompressor() { jpeg_destroy_decompress(&cinfo); }
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;

  JpegErrorHandler errors;
  jpeg_decompress_struct cinfo{};
};

/// Without local objects that have a destructor, because longjmp skips them.
const char* decompress(Decompressor& decompressor, std::span<const std::uint8_t> jpeg, ImageSize expected,
                       std::uint8_t* bgra) {
  jpeg_decompress_struct& cinfo = decompressor.cinfo;
  if (setjmp(decompressor.errors.back) != 0) return kInvalidJpeg;
  jpeg_mem_src(&cinfo, jpeg.data(), static_cast<unsigned long>(jpeg.size()));
  jpeg_read_header(&cinfo, TRUE);
  if (cinfo.image_width != static_cast<JDIMENSION>(expected.width) ||
      cinfo.image_height != static_cast<JDIMENSION>(expected.height))
    return kUnexpectedSize;
  if (jpeg_has_multiple_scans(&cinfo) != FALSE) return "multiple scans are not supported";  // includes progressive JPEG
  if (cinfo.jpeg_color_space != JCS_YCbCr) return "not a colour picture";
  cinfo.out_color_space = JCS_EXT_BGRA;  // A is 255
  jpeg_start_decompress(&cinfo);
  const std::size_t row_bytes = std::size_t{4} * cinfo.image_width;
  while (cinfo.output_scanline < cinfo.output_height) {
    std::array<JSAMPROW, 1> rows{bgra + row_bytes * cinfo.output_scanline};
    jpeg_read_scanlines(&cinfo, rows.data(), 1);
  }
  jpeg_finish_decompress(&cinfo);
  // libjpeg fills missing data and counts a warning.
  return decompressor.errors.manager.num_warnings == 0 ? nullptr : "damaged";
}

/// Reads the frame header at `at`, after marker and length.
std::optional<ImageSize> sizeInFrame(std::span<const std::uint8_t> jpeg, std::size_t at) {
  if (jpeg.size() < at + 5) return std::nullopt;
  const ImageSize size{.width = jpeg[at + 3] << 8 | jpeg[at + 4], .height = jpeg[at + 1] << 8 | jpeg[at + 2]};
  return isImageSize(size) ? std::optional{size} : std::nullopt;
}

}  // namespace

std::optional<ImageSize> imageSizeOf(std::span<const std::uint8_t> jpeg) {
  constexpr std::uint8_t kMarker = 0xFF, kStartOfImage = 0xD8, kBaseline = 0xC0, kProgressive = 0xC2;
  if (jpeg.size() < 2 || jpeg[0] != kMarker || jpeg[1] != kStartOfImage) return std::nullopt;
  // Segment: 0xFF, marker code, length including its own two bytes.
  for (std::size_t at = 2; at + 4 <= jpeg.size() && jpeg[at] == kMarker;) {
    if (jpeg[at + 1] >= kBaseline && jpeg[at + 1] <= kProgressive) return sizeInFrame(jpeg, at + 4);
    at += 2U + (static_cast<std::size_t>(jpeg[at + 2]) << 8 | jpeg[at + 3]);
  }
  return std::nullopt;
}

const char* decodeJpeg(std::span<const std::uint8_t> jpeg, ImageSize expected, std::span<std::uint8_t> bgra) {
  assert(bgra.size() == static_cast<std::size_t>(4 * expected.width * expected.height));
  if (jpeg.empty()) return kEmptyJpeg;
  Decompressor decompressor;
  return decompress(decompressor, jpeg, expected, bgra.data());
}

}  // namespace darwinop::remote
