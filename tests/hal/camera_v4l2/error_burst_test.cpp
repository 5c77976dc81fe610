// When errors of reading are more than damaged pictures.
#include "hal/camera_v4l2/error_burst.hpp"

#include <gtest/gtest.h>

namespace darwinop::v4l2 {
namespace {

using namespace std::chrono_literals;

TEST(ErrorBurst, IsNoneWhileErrorsComeAsPicturesDo) {
  ErrorBurst errors;
  std::chrono::nanoseconds now = 1h;
  for (int i = 0; i < 1000; ++i) ASSERT_FALSE(errors.add(now += 33ms));
}

TEST(ErrorBurst, IsNoneWhenFourWaitedForALateThread) {
  ErrorBurst errors;
  std::chrono::nanoseconds now = 1h;
  for (int round = 0; round < 10; ++round, now += 133ms)
    for (int i = 0; i < 4; ++i) ASSERT_FALSE(errors.add(now));
}

TEST(ErrorBurst, IsNineAtOnce) {
  ErrorBurst errors;
  for (int i = 0; i < 8; ++i) ASSERT_FALSE(errors.add(1h + i * 10ms));
  EXPECT_TRUE(errors.add(1h + 90ms));
}

TEST(ErrorBurst, IsOverWithAPicture) {
  ErrorBurst errors;
  for (int i = 0; i < 8; ++i) ASSERT_FALSE(errors.add(1h));
  errors.over();
  for (int i = 0; i < 8; ++i) ASSERT_FALSE(errors.add(1h));
  EXPECT_TRUE(errors.add(1h));
}

}  // namespace
}  // namespace darwinop::v4l2
