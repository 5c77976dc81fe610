// Direct reader of the painter's file.
#include "hil-mocks/camera/painted_pictures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "hil-mocks/camera/frame_painter.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::hil {
namespace {

std::vector<std::uint8_t> plainYuyv(PictureSize size, std::uint8_t value) {
  return std::vector<std::uint8_t>(2 * static_cast<std::size_t>(size.width * size.height), value);
}

TEST(PaintedPictures, AreReadAndRequested) {
  const TemporaryFolder folder;
  FramePainter painter{folder / "eyes"};
  PaintedPictures eyes{folder / "eyes", true};
  EXPECT_EQ(painter.wantedRate(), 0) << "no reader yet";
  EXPECT_EQ(eyes.newest().sequence, 0U);
  EXPECT_EQ(painter.wantedRate(), 15);
  EXPECT_FALSE(eyes.health().seeing);
  painter.paintYuyv({320, 240}, plainYuyv({320, 240}, 7));
  const CameraFrame frame = eyes.newest();
  EXPECT_EQ(frame.sequence, 1U);
  ASSERT_EQ(frame.yuyv.size(), 2U * 320 * 240);
  EXPECT_EQ(frame.yuyv.back(), 7);
  EXPECT_TRUE(eyes.health().seeing);
}

TEST(PaintedPictures, OfAnotherSizeAreNotShown) {
  const TemporaryFolder folder;
  FramePainter painter{folder / "eyes"};
  PaintedPictures eyes{folder / "eyes", false};
  painter.paintYuyv({640, 480}, plainYuyv({640, 480}, 7));
  EXPECT_EQ(eyes.newest().sequence, 0U);
  painter.paintYuyv({320, 240}, plainYuyv({320, 240}, 9));
  EXPECT_EQ(eyes.newest().sequence, 2U);
}

TEST(PaintedPictures, AnOldPictureIsIgnored) {
  const TemporaryFolder folder;
  FramePainter painter{folder / "eyes"};
  painter.paintYuyv({320, 240}, plainYuyv({320, 240}, 7));
  {
    std::fstream file{folder / "eyes", std::ios::in | std::ios::out | std::ios::binary};
    FrameFile head;
    file.seekp(reinterpret_cast<const char*>(&head.painted_ns[1]) - reinterpret_cast<const char*>(&head));
    const std::int64_t before = frameFileClock() - 3'000'000'000;
    file.write(reinterpret_cast<const char*>(&before), sizeof before);
  }
  PaintedPictures eyes{folder / "eyes", true};
  EXPECT_EQ(eyes.newest().sequence, 0U) << "left from an earlier reader";
}

TEST(PaintedPictures, APainterReportsWhyItCannotPaint) {
  const TemporaryFolder folder;
  FramePainter painter{folder / "eyes"};
  const PaintedPictures eyes{folder / "eyes", true};
  EXPECT_EQ(eyes.error(), "");
  painter.giveUp(std::string(600, '.'));
  painter.giveUp("something else");
  EXPECT_EQ(eyes.error(), std::string(511, '.'));
}

TEST(PaintedPictures, AnInvalidFileIsRejected) {
  const TemporaryFolder folder;
  EXPECT_THROW((PaintedPictures{folder / "eyes", true}), std::runtime_error);
  std::ofstream{folder / "eyes"} << "too short to be mapped";
  EXPECT_THROW((PaintedPictures{folder / "eyes", true}), std::runtime_error);
  std::ofstream{folder / "eyes"} << std::string(kFrameFileSize, 'x');
  EXPECT_THROW((PaintedPictures{folder / "eyes", true}), std::runtime_error);
}

}  // namespace
}  // namespace darwinop::hil
