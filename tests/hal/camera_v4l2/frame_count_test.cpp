// From the driver's count to numbers that a controller can rely on.
#include "hal/camera_v4l2/frame_count.hpp"

#include <gtest/gtest.h>

namespace darwinop::v4l2 {
namespace {

TEST(FrameCount, BeginsAtOneWhateverTheDriverBeginsWith) {
  FrameCount count;
  EXPECT_EQ(count.next(4711).sequence, 1u);
  const auto second = count.next(4712);
  EXPECT_EQ(second.sequence, 2u);
  EXPECT_EQ(second.dropped, 0u);
}

TEST(FrameCount, JumpsOverWhatTheDriverLost) {
  FrameCount count;
  count.next(0);
  const auto after = count.next(3);
  EXPECT_EQ(after.sequence, 4u);
  EXPECT_EQ(after.dropped, 2u);
}

TEST(FrameCount, SurvivesTheWrapOfTheDriversCount) {
  FrameCount count;
  count.next(0xFFFF'FFFE);
  const auto after = count.next(1);
  EXPECT_EQ(after.sequence, 4u);
  EXPECT_EQ(after.dropped, 2u);
}

TEST(FrameCount, GoesOnWithACountThatStandsStillOrRunsBack) {
  FrameCount count;
  count.next(10);
  EXPECT_EQ(count.next(10).sequence, 2u);
  const auto after = count.next(5);
  EXPECT_EQ(after.sequence, 3u);
  EXPECT_EQ(after.dropped, 0u);
}

TEST(FrameCount, LeavesAGapWhereTheCameraWasOpenedAnew) {
  FrameCount count;
  count.restart();
  EXPECT_EQ(count.next(0).sequence, 1u);
  count.restart();
  const auto after = count.next(0);
  EXPECT_EQ(after.sequence, 3u);
  EXPECT_EQ(after.dropped, 0u);
}

TEST(FrameCount, DoesNotCallADamagedPictureDroppedToo) {
  FrameCount count;
  count.next(0);
  count.unnumbered();
  const auto after = count.next(3);
  EXPECT_EQ(after.sequence, 4u);
  EXPECT_EQ(after.dropped, 1u);
  EXPECT_EQ(count.next(4).dropped, 0u);
}

}  // namespace
}  // namespace darwinop::v4l2
