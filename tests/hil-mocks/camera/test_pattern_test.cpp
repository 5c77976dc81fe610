// Test patterns.
#include "hil-mocks/camera/test_pattern.hpp"

#include <gtest/gtest.h>

namespace darwinop::hil {
namespace {

/// Centre of the ball's pixels.
PaintedBall seen(const PaintedPicture& picture) {
  double x_sum = 0, y_sum = 0, count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (picture.colour(x, y) == kBallColour) {
        x_sum += x + 0.5;
        y_sum += y + 0.5;
        ++count;
      }
  return {x_sum / count, y_sum / count, count};
}

TEST(TestPattern, TheBallIsAtTheComputedPosition) {
  for (const auto& [width, height] : {std::pair{320, 240}, {800, 600}, {640, 360}})
    for (const double seconds : {0.0, 0.7, 2.0, 3.9, 100.3}) {
      PaintedPicture picture{width, height};
      drawBall(picture, seconds);
      const PaintedBall ball = ballAt(width, height, seconds), found = seen(picture);
      EXPECT_NEAR(found.x, ball.x, 0.2) << width << ' ' << seconds;
      EXPECT_NEAR(found.y, ball.y, 0.2) << width << ' ' << seconds;
      EXPECT_NEAR(found.radius, 3.14159 * ball.radius * ball.radius, 0.03 * found.radius);
    }
}

TEST(TestPattern, TheBallStartsAtTheRightAndMovesDown) {
  EXPECT_NEAR(ballAt(320, 240, 0).x, 220, 1e-9);
  EXPECT_NEAR(ballAt(320, 240, 0).y, 120, 1e-9);
  EXPECT_NEAR(ballAt(320, 240, 1).x, 160, 1e-9);
  EXPECT_NEAR(ballAt(320, 240, 1).y, 180, 1e-9);
  EXPECT_NEAR(ballAt(320, 240, 4).x, 220, 1e-9);
}

TEST(TestPattern, BarsAreOrderedFromLeftToRight) {
  PaintedPicture picture{640, 480};
  drawBars(picture, 0);
  for (int bar = 0; bar < 8; ++bar) {
    EXPECT_EQ(picture.colour(80 * bar, 0), kBars[bar]);
    EXPECT_EQ(picture.colour(80 * bar + 79, 419), kBars[bar]);
  }
  EXPECT_EQ(picture.bgra[3], 255);
}

TEST(TestPattern, TheFrameNumberCanBeDecoded) {
  PaintedPicture small{320, 240}, large{800, 600};
  for (const std::uint32_t number : {0u, 1u, 2u, 0x1234u, 0xFFFFu, 0x8000u}) {
    drawBars(small, number);
    drawBars(large, number);
    EXPECT_EQ(frameNumber(small), number);
    EXPECT_EQ(frameNumber(large), number);
  }
}

}  // namespace
}  // namespace darwinop::hil
