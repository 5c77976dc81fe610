// libjpeg with preallocated memory.
#include "remote/jpeg/image_memory.hpp"

#include <gtest/gtest.h>

#include <array>

#include "remote/jpeg/jpeg_errors.hpp"

namespace darwinop::remote {
namespace {

struct ImageMemoryTest : testing::Test {
  ImageMemoryTest() {
    cinfo.err = &errors.manager;
    jpeg_create_compress(&cinfo);
  }
  ~ImageMemoryTest() override { jpeg_destroy_compress(&cinfo); }

  /// Encodes a black picture with colour conversion, the longest path through libjpeg. False: libjpeg reported an
  /// error.
  bool writePicture(JDIMENSION width, JDIMENSION height) {
    errors.expected = true;
    if (setjmp(errors.back) != 0) {
      jpeg_abort_compress(&cinfo);
      return false;
    }
    unsigned char* to = file.data();
    auto length = static_cast<unsigned long>(file.size());
    jpeg_mem_dest(&cinfo, &to, &length);
    cinfo.image_width = width;
    cinfo.image_height = height;
    cinfo.input_components = 4;
    cinfo.in_color_space = JCS_EXT_BGRX;
    jpeg_set_defaults(&cinfo);
    jpeg_start_compress(&cinfo, TRUE);
    while (cinfo.next_scanline < height) {
      std::array<JSAMPROW, 1> rows{row.data()};
      jpeg_write_scanlines(&cinfo, rows.data(), 1);
    }
    jpeg_finish_compress(&cinfo);
    return true;
  }

  JpegErrorHandler errors;
  jpeg_compress_struct cinfo{};
  std::vector<unsigned char> file = std::vector<unsigned char>(1'000'000), row = std::vector<unsigned char>(4 * 8000);
};

TEST_F(ImageMemoryTest, IsReusedForEachPicture) {
  ImageMemory memory{cinfo};
  ASSERT_TRUE(writePicture(320, 240));
  const std::size_t of_one = memory.most();
  EXPECT_GT(of_one, 10'000u) << "libjpeg works with memory from elsewhere";
  EXPECT_LT(of_one, 32'000u) << "more than half of 64 KiB";
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(writePicture(320, 240));
  EXPECT_EQ(memory.most(), of_one);
}

TEST_F(ImageMemoryTest, ReportsAnErrorWhenItIsFull) {
  ImageMemory memory{cinfo};
  EXPECT_FALSE(writePicture(8000, 16));
  EXPECT_TRUE(writePicture(320, 240));
}

}  // namespace
}  // namespace darwinop::remote
