// libjpeg on memory of its owner's.
#include "remote/jpeg/image_memory.hpp"

#include <gtest/gtest.h>

#include <array>

#include "remote/jpeg/complaints.hpp"

namespace darwinop::remote {
namespace {

struct ImageMemoryTest : testing::Test {
  ImageMemoryTest() {
    cinfo.err = &complaints.manager;
    jpeg_create_compress(&cinfo);
  }
  ~ImageMemoryTest() override { jpeg_destroy_compress(&cinfo); }

  /// Black; the longest way through libjpeg, with a conversion of colours. False: it was given up.
  bool writePicture(JDIMENSION width, JDIMENSION height) {
    complaints.expected = true;
    if (setjmp(complaints.back) != 0) {
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

  JpegComplaints complaints;
  jpeg_compress_struct cinfo{};
  std::vector<unsigned char> file = std::vector<unsigned char>(1'000'000), row = std::vector<unsigned char>(4 * 8000);
};

TEST_F(ImageMemoryTest, IsUsedForEachPictureAnew) {
  ImageMemory memory{cinfo};
  ASSERT_TRUE(writePicture(320, 240));
  const std::size_t of_one = memory.most();
  EXPECT_GT(of_one, 10'000u) << "libjpeg works with memory from elsewhere";
  EXPECT_LT(of_one, 32'000u) << "more than half of 64 KiB";
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(writePicture(320, 240));
  EXPECT_EQ(memory.most(), of_one);
}

TEST_F(ImageMemoryTest, EndsWithAnErrorNotBeyondItsEnd) {
  ImageMemory memory{cinfo};
  EXPECT_FALSE(writePicture(8000, 16));
  EXPECT_TRUE(writePicture(320, 240));
}

}  // namespace
}  // namespace darwinop::remote
