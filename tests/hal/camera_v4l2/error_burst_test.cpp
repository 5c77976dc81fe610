// Distinguishing bursts of read errors from damaged pictures.
#include "hal/camera_v4l2/error_burst.hpp"

#include <gtest/gtest.h>

namespace darwinop::v4l2 {
namespace {

using namespace std::chrono_literals;

TEST(ErrorBurst, IsNotReportedAtThePictureRate) {
  ErrorBurst errors;
  std::chrono::nanoseconds now = 1h;
  for (int i = 0; i < 1000; ++i) ASSERT_FALSE(errors.add(now += 33ms));
}

TEST(ErrorBurst, IsNotReportedForFourBufferedErrors) {
  ErrorBurst errors;
  std::chrono::nanoseconds now = 1h;
  for (int round = 0; round < 10; ++round, now += 133ms)
    for (int i = 0; i < 4; ++i) ASSERT_FALSE(errors.add(now));
}

TEST(ErrorBurst, IsNineImmediateErrors) {
  ErrorBurst errors;
  for (int i = 0; i < 8; ++i) ASSERT_FALSE(errors.add(1h + i * 10ms));
  EXPECT_TRUE(errors.add(1h + 90ms));
}

TEST(ErrorBurst, EndsWithAPicture) {
  ErrorBurst errors;
  for (int i = 0; i < 8; ++i) ASSERT_FALSE(errors.add(1h));
  errors.over();
  for (int i = 0; i < 8; ++i) ASSERT_FALSE(errors.add(1h));
  EXPECT_TRUE(errors.add(1h));
}

}  // namespace
}  // namespace darwinop::v4l2
