// Decoder with valid, damaged and unsupported files.
#include "remote/jpeg/decoder.hpp"

#include <string>

#include "remote/jpeg/scenes.hpp"

namespace darwinop::remote {
namespace {

struct DecodeJpegTest : testing::Test {
  static constexpr ImageSize kSize{80, 60};
  Scene scene = room();
  JpegEncoder encoder{kSize, 80};
  PixelBytes good = encoded(encoder, scene.frame(PictureForm::kYuyv));
  PixelBytes bgra = PixelBytes(4 * pixelsOf(kSize));

  std::string wrongWith(const PixelBytes& jpeg) {
    const char* wrong = decodeJpeg(jpeg, kSize, bgra);
    return wrong == nullptr ? "" : wrong;
  }
};

TEST_F(DecodeJpegTest, WritesFourBytesPerPixelWithOpaqueAlpha) {
  EXPECT_EQ(wrongWith(good), "");
  for (std::size_t alpha = 3; alpha < bgra.size(); alpha += 4) ASSERT_EQ(bgra[alpha], 255);
}

TEST_F(DecodeJpegTest, RejectsAFileThatIsNotAJpeg) {
  EXPECT_EQ(wrongWith({}), kEmptyJpeg);
  EXPECT_EQ(wrongWith(PixelBytes(100, 0)), kInvalidJpeg);
  EXPECT_EQ(wrongWith({0xff, 0xd8, 0xff, 0xe0, 0x00, 0x10, 0xff, 0xd9}), kInvalidJpeg);
}

TEST_F(DecodeJpegTest, RejectsAnUnexpectedSize) {
  JpegEncoder other{{80, 120}, 80};
  EXPECT_EQ(wrongWith(encoded(other, scene.frame(PictureForm::kYuyv))), kUnexpectedSize);
}

TEST_F(DecodeJpegTest, RejectsATruncatedFile) {
  for (std::size_t length = 1; length < good.size() - 2; length += 7)
    EXPECT_NE(wrongWith({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)}), "") << length;
}

TEST_F(DecodeJpegTest, RejectsMultipleScans) {
  PixelBytes progressive = good;
  // Marker SOF0 (baseline) becomes SOF2 (progressive).
  const std::uint8_t marker[]{0xff, 0xc0};
  const auto found = std::search(progressive.begin(), progressive.end(), std::begin(marker), std::end(marker));
  ASSERT_NE(found, progressive.end());
  found[1] = 0xc2;
  EXPECT_NE(wrongWith(progressive), "");
}

TEST_F(DecodeJpegTest, DoesNotReuseTablesOfThePreviousFile) {
  EXPECT_EQ(wrongWith(good), "");
  // Renumbers both quantization tables, so that those the picture refers to are missing.
  PixelBytes without = good;
  for (std::size_t i = 0; i + 4 < without.size(); ++i)
    if (without[i] == 0xff && without[i + 1] == 0xdb) without[i + 4] += 2;
  ASSERT_NE(without, good);
  EXPECT_EQ(wrongWith(without), kInvalidJpeg);
}

}  // namespace
}  // namespace darwinop::remote
