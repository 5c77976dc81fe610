#include "remote/jpeg/decoder.hpp"

#include <array>
#include <cassert>
#include <csetjmp>

#include "remote/jpeg/complaints.hpp"

namespace darwinop::remote {

struct JpegDecoder::Work {
  Work() {
    cinfo.err = &complaints.manager;
    jpeg_create_decompress(&cinfo);
    complaints.expected = true;
  }
  ~Work() { jpeg_destroy_decompress(&cinfo); }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  const char* read(std::span<const std::uint8_t> jpeg, ImageSize expected, std::uint8_t* bgra);

  jpeg_decompress_struct cinfo{};
  JpegComplaints complaints;
};

const char* JpegDecoder::Work::read(std::span<const std::uint8_t> jpeg, ImageSize expected, std::uint8_t* bgra) {
  jpeg_mem_src(&cinfo, jpeg.data(), static_cast<unsigned long>(jpeg.size()));
  jpeg_read_header(&cinfo, TRUE);
  if (cinfo.image_width != static_cast<JDIMENSION>(expected.width) ||
      cinfo.image_height != static_cast<JDIMENSION>(expected.height))
    return "it has another size";
  if (cinfo.progressive_mode != FALSE || jpeg_has_multiple_scans(&cinfo) != FALSE) return "it is coded in many passes";
  if (cinfo.jpeg_color_space != JCS_YCbCr) return "it is no picture in colours";
  cinfo.out_color_space = JCS_EXT_BGRA;  // A is 255
  jpeg_start_decompress(&cinfo);
  const std::size_t row_bytes = std::size_t{4} * cinfo.image_width;
  while (cinfo.output_scanline < cinfo.output_height) {
    std::array<JSAMPROW, 1> rows{bgra + row_bytes * cinfo.output_scanline};
    jpeg_read_scanlines(&cinfo, rows.data(), 1);
  }
  jpeg_finish_decompress(&cinfo);
  // libjpeg makes up what is missing, and says so.
  return complaints.manager.num_warnings == 0 ? nullptr : "it is damaged";
}

JpegDecoder::JpegDecoder() : work_{std::make_unique<Work>()} {}
JpegDecoder::~JpegDecoder() = default;

const char* JpegDecoder::decode(std::span<const std::uint8_t> jpeg, ImageSize expected,
                                std::span<std::uint8_t> bgra) noexcept {
  assert(bgra.size() == std::size_t{4} * expected.width * expected.height);
  if (jpeg.empty()) return "it is empty";
  Work& work = *work_;
  // Up to the end nothing has a destructor that a jump would leave out.
  if (setjmp(work.complaints.back) != 0) {
    jpeg_abort_decompress(&work.cinfo);
    return "it is no JPEG, or damaged";
  }
  const char* wrong = work.read(jpeg, expected, bgra.data());
  jpeg_abort_decompress(&work.cinfo);
  return wrong;
}

}  // namespace darwinop::remote
