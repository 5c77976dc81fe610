// JPEGs of a camera's frames, looked at through a decoder.
#include "remote/jpeg/encoder.hpp"

#include <string>

#include "remote/jpeg/scenes.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop::remote {
namespace {

constexpr auto kForms = std::to_array({PictureForm::kYuyv, PictureForm::kBgra});

template <class Look>
void withEachSizeAndForm(Look&& look) {
  for (const int width : kImageWidths)
    for (const int height : kImageHeights)
      for (const PictureForm form : kForms) {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) +
                     (form == PictureForm::kYuyv ? " of YUYV" : " of BGRA"));
        look(ImageSize{width, height}, form);
      }
}

TEST(JpegEncoder, KeepsThePictureAtEachSize) {
  const Scene scene = room();
  withEachSizeAndForm([&](ImageSize size, PictureForm form) {
    JpegEncoder encoder{size, qualityOf(size)};
    const PixelBytes jpeg = encoded(encoder, scene.frame(form));
    EXPECT_GT(psnr(scene, decoded(jpeg, size), size), 28.0);
    EXPECT_LT(jpeg.size(), 700 + pixelsOf(size) / 2);
  });
}

TEST(JpegEncoder, ShowsMoreAtHigherQuality) {
  const Scene scene = room();
  for (const PictureForm form : kForms) {
    double last = 0;
    std::size_t last_bytes = 0;
    for (const int quality : {20, 50, 65, 80, 100}) {
      JpegEncoder encoder{kWholeImage, quality};
      const PixelBytes jpeg = encoded(encoder, scene.frame(form));
      const double now = psnr(scene, decoded(jpeg, kWholeImage), kWholeImage);
      EXPECT_GT(now, last) << quality;
      EXPECT_GT(jpeg.size(), last_bytes) << quality;
      last = now;
      last_bytes = jpeg.size();
    }
    EXPECT_GT(last, 32);
  }
}

TEST(JpegEncoder, IsNotWorseFromPlanesThanFromPixels) {
  const Scene scene = room();
  for (const int quality : {50, 65, 80, 100}) {
    JpegEncoder encoder{kWholeImage, quality};
    const auto quality_of = [&](PictureForm form) {
      return psnr(scene, decoded(encoded(encoder, scene.frame(form)), kWholeImage), kWholeImage);
    };
    EXPECT_GE(quality_of(PictureForm::kYuyv), quality_of(PictureForm::kBgra)) << quality;
  }
}

TEST(JpegEncoder, TakesTheMiddleToThePixel) {
  const Scene scene = room();
  withEachSizeAndForm([&](ImageSize size, PictureForm form) {
    JpegEncoder encoder{size, 90};
    const PixelBytes bgra = decoded(encoded(encoder, scene.frame(form)), size);
    const double there = psnr(scene, bgra, size);
    for (int down = -1; down <= 1; ++down)
      for (int right = -1; right <= 1; ++right) {
        const bool inside = std::abs(right) <= leftOf(size) && std::abs(down) <= topOf(size);
        if ((right == 0 && down == 0) || !inside) continue;
        EXPECT_GT(there, psnr(scene, bgra, size, right, down) + 3) << right << " right, " << down << " down";
      }
  });
}

TEST(JpegEncoder, PairsTheRowsOfTheImageNotOfTheCamera) {
  // An image of 30 rows begins in row 105: red above row 107, blue below, in step with the image's own pairs.
  const Scene scene{[](int, int y) { return y < 107 ? std::array{0, 0, 200} : std::array{200, 0, 0}; }};
  const ImageSize size{40, 30};
  JpegEncoder encoder{size, 100};
  const auto of_row = [&](const PixelBytes& bgra, int row) { return bgra.data() + std::ptrdiff_t{4} * 40 * row; };
  // Paired with row 106, row 105 of the camera keeps its red; paired across the edge it would be half blue.
  const PixelBytes planes = decoded(encoded(encoder, scene.frame(PictureForm::kYuyv)), size);
  const PixelBytes pixels = decoded(encoded(encoder, scene.frame(PictureForm::kBgra)), size);
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(of_row(planes, row)[i], of_row(pixels, row)[i], 6) << row;
}

TEST(JpegEncoder, HasRoomForNoiseAtFullQuality) {
  std::uint32_t dice = 1;
  const Scene scene{[&](int, int) {
    dice = dice * 1664525 + 1013904223;
    return std::array{dice >> 24, dice >> 16 & 255, dice >> 8 & 255};
  }};
  withEachSizeAndForm([&](ImageSize size, PictureForm form) {
    JpegEncoder encoder{size, 100};
    EXPECT_EQ(decoded(encoded(encoder, scene.frame(form)), size).size(), 4 * pixelsOf(size));
  });
}

TEST(JpegEncoder, WritesTheSameFileEachTimeAndForEachFormInTurn) {
  const Scene scene = room();
  JpegEncoder encoder{{160, 120}, 80}, other{{160, 120}, 80};
  const PixelBytes planes = encoded(encoder, scene.frame(PictureForm::kYuyv));
  const PixelBytes pixels = encoded(encoder, scene.frame(PictureForm::kBgra));
  EXPECT_EQ(encoded(encoder, scene.frame(PictureForm::kYuyv)), planes);
  EXPECT_EQ(encoded(encoder, scene.frame(PictureForm::kBgra)), pixels);
  EXPECT_EQ(encoded(other, scene.frame(PictureForm::kYuyv)), planes);
}

TEST(JpegEncoder, TakesNothingFromTheHeapAfterTheFirst) {
  const Scene scene = room();
  for (const PictureForm form : kForms) {
    JpegEncoder encoder{kWholeImage, 65};
    PixelBytes into(encoder.mostBytes());
    const CameraFrame frame = scene.frame(form);
    EXPECT_GT(encoder.encode(frame, into), 0u);
    const long before = allocationsOfThisThread();
    EXPECT_GT(encoder.encode(frame, into), 0u);
    EXPECT_EQ(allocationsOfThisThread(), before);
  }
}

TEST(JpegEncoder, LeavesAFrameAloneThatIsNotOfTheWholeSize) {
  const Scene scene = room();
  JpegEncoder encoder{{80, 60}, 80};
  PixelBytes into(encoder.mostBytes());
  CameraFrame frame = scene.frame(PictureForm::kBgra);
  frame.height = 120;
  EXPECT_EQ(encoder.encode(frame, into), 0u);
  frame = scene.frame(PictureForm::kYuyv);
  frame.yuyv = frame.yuyv.first(100);
  EXPECT_EQ(encoder.encode(frame, into), 0u);
  EXPECT_EQ(encoder.encode(scene.frame(PictureForm::kYuyv), std::span{into}.first(1000)), 0u);
  EXPECT_GT(encoder.encode(scene.frame(PictureForm::kYuyv), into), 0u);
}

TEST(JpegEncoder, RefusesOtherSizesAndQualities) {
  EXPECT_THROW((JpegEncoder{{100, 100}, 80}), std::invalid_argument);
  EXPECT_THROW((JpegEncoder{{320, 240}, 0}), std::invalid_argument);
  EXPECT_THROW((JpegEncoder{{320, 240}, 101}), std::invalid_argument);
}

}  // namespace
}  // namespace darwinop::remote
