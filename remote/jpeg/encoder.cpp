// JPEG encoder without allocation per picture, with libjpeg-turbo.
#include "remote/jpeg/encoder.hpp"

#include <jerror.h>

#include <array>
#include <csetjmp>
#include <stdexcept>
#include <string>
#include <vector>

#include "hal/pixels/yuyv_to_planes.hpp"
#include "remote/jpeg/image_memory.hpp"
#include "remote/jpeg/jpeg_errors.hpp"

namespace darwinop::remote {
namespace {

constexpr int kUnit = 16;  // pixels: width and height of an MCU with 4:2:0

constexpr int wholeUnits(int pixels) {
  return (pixels + kUnit - 1) / kUnit * kUnit;
}

/// Padding up to a whole unit is taken from the camera's picture. There is always enough of it: an image whose size is
/// not a multiple of the unit ends inside the picture.
constexpr bool unitsAreInside() {
  for (const int width : kImageWidths)
    if (leftOf({width, 240}) + wholeUnits(width) > kWholeImage.width || leftOf({width, 240}) % 2 != 0) return false;
  for (const int height : kImageHeights)
    if (topOf({320, height}) + wholeUnits(height) > kWholeImage.height) return false;
  return true;
}
static_assert(unitsAreInside());

}  // namespace

struct JpegEncoder::Work {
  /// Writes the file to the caller's buffer.
  struct Destination {
    explicit Destination(jpeg_compress_struct& owner) {
      owner.dest = &manager;
      manager.init_destination = [](j_compress_ptr) {};
      manager.term_destination = [](j_compress_ptr) {};
      manager.empty_output_buffer = [](j_compress_ptr full) -> boolean {
        full->err->msg_code = JERR_BUFFER_SIZE;
        full->err->error_exit(reinterpret_cast<j_common_ptr>(full));
        return FALSE;
      };
    }
    jpeg_destination_mgr manager{};
  };

  Work(ImageSize image_size, int image_quality)
      : size{image_size},
        coded{wholeUnits(size.width), wholeUnits(size.height)},
        quality{image_quality},
        luma(static_cast<std::size_t>(coded.width) * coded.height),
        blue(luma.size() / 4),
        red(luma.size() / 4) {
    errors.expected = true;
  }
  ~Work() { jpeg_destroy_compress(&cinfo); }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  jpeg_compress_struct& made() {
    cinfo.err = &errors.manager;
    jpeg_create_compress(&cinfo);
    return cinfo;
  }
  void prepare(PictureForm wanted) noexcept;
  void planesOf(const CameraFrame& frame) noexcept;
  void writePlanes();
  void writeRows(const CameraFrame& frame);

  ImageSize size, coded;
  int quality;
  jpeg_compress_struct cinfo{};
  JpegErrorHandler errors;
  ImageMemory memory{made()};
  Destination destination{cinfo};
  PictureForm form{};
  bool prepared = false;
  std::vector<std::uint8_t> luma, blue, red;  // of `coded`
};

/// libjpeg keeps these settings between pictures. Accurate DCT: the fast one is not faster with SSE2 or AVX2.
void JpegEncoder::Work::prepare(PictureForm wanted) noexcept {
  if (prepared && form == wanted) return;
  const bool planes = wanted == PictureForm::kYuyv;
  cinfo.image_width = static_cast<JDIMENSION>(size.width);
  cinfo.image_height = static_cast<JDIMENSION>(size.height);
  cinfo.input_components = planes ? 3 : 4;
  cinfo.in_color_space = planes ? JCS_YCbCr : JCS_EXT_BGRX;
  jpeg_set_defaults(&cinfo);
  jpeg_set_quality(&cinfo, quality, TRUE);
  cinfo.raw_data_in = planes ? TRUE : FALSE;
  form = wanted;
  prepared = true;
}

/// Crops first, then subsamples: an image that starts at an odd row takes its chroma from its own row pairs.
void JpegEncoder::Work::planesOf(const CameraFrame& frame) noexcept {
  const std::size_t stride = pixels::yuyvRowBytes(frame.width);
  // The camera is mounted upside down: pixels right of and below the crop come first.
  const int before = frame.width - leftOf(size) - coded.width, above = frame.height - topOf(size) - coded.height;
  pixels::yuyvToPlanesRotated(
      {frame.yuyv.subspan(stride * above + std::size_t{2} * before), coded.width, coded.height, stride},
      pixels::Chroma::k420, {luma, blue, red});
}

void JpegEncoder::Work::writePlanes() {
  const int half = coded.width / 2;
  while (cinfo.next_scanline < cinfo.image_height) {
    const int top = static_cast<int>(cinfo.next_scanline);
    std::array<JSAMPROW, kUnit> luma_rows;
    std::array<JSAMPROW, kUnit / 2> blue_rows, red_rows;
    for (int row = 0; row < kUnit; ++row) luma_rows[row] = luma.data() + coded.width * (top + row);
    for (int row = 0; row < kUnit / 2; ++row) {
      blue_rows[row] = blue.data() + half * (top / 2 + row);
      red_rows[row] = red.data() + half * (top / 2 + row);
    }
    std::array<JSAMPARRAY, 3> planes{luma_rows.data(), blue_rows.data(), red_rows.data()};
    jpeg_write_raw_data(&cinfo, planes.data(), kUnit);
  }
}

void JpegEncoder::Work::writeRows(const CameraFrame& frame) {
  while (cinfo.next_scanline < cinfo.image_height) {
    const std::size_t row = static_cast<std::size_t>(topOf(size)) + cinfo.next_scanline;
    const std::uint8_t* from = frame.bgra.data() + 4 * (row * frame.width + leftOf(size));
    std::array<JSAMPROW, 1> rows{const_cast<JSAMPROW>(from)};  // libjpeg only reads
    jpeg_write_scanlines(&cinfo, rows.data(), 1);
  }
}

JpegEncoder::JpegEncoder(ImageSize size, int quality) {
  if (!isImageSize(size))
    throw std::invalid_argument("image size " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                                " is not supported: width 320, 160, 80 or 40, height 240, 120, 60 or 30");
  if (quality < 1 || quality > 100)
    throw std::invalid_argument("JPEG quality " + std::to_string(quality) + " is out of range: 1 to 100");
  work_ = std::make_unique<Work>(size, quality);
}

JpegEncoder::~JpegEncoder() = default;

std::size_t JpegEncoder::mostBytes() const noexcept {
  // Headers and tables, plus two bytes per 4:2:0 sample: the bound of libjpeg-turbo's tjBufSize().
  return 2048 + 3 * work_->luma.size();
}

std::size_t JpegEncoder::encode(const CameraFrame& frame, std::span<std::uint8_t> into) noexcept {
  Work& work = *work_;
  if (ImageSize{frame.width, frame.height} != kWholeImage || into.size() < mostBytes()) return 0;
  const bool planes = !frame.yuyv.empty();
  constexpr std::size_t kPixels = std::size_t{320} * 240;
  if (planes ? frame.yuyv.size() != 2 * kPixels : frame.bgra.size() != 4 * kPixels) return 0;

  if (planes) work.planesOf(frame);
  // No local object below has a destructor, because longjmp skips them.
  if (setjmp(work.errors.back) != 0) {
    jpeg_abort_compress(&work.cinfo);
    return 0;
  }
  work.prepare(planes ? PictureForm::kYuyv : PictureForm::kBgra);
  work.destination.manager.next_output_byte = into.data();
  work.destination.manager.free_in_buffer = into.size();
  jpeg_start_compress(&work.cinfo, TRUE);
  if (planes)
    work.writePlanes();
  else
    work.writeRows(frame);
  jpeg_finish_compress(&work.cinfo);
  return into.size() - work.destination.manager.free_in_buffer;
}

}  // namespace darwinop::remote
