// Waiting for a device, and being called away from it.
#include "hal/camera_v4l2/wake.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace darwinop::v4l2 {
namespace {

using namespace std::chrono_literals;

TEST(Wake, IsCalledAwayAtOnce) {
  Wake wake;
  const auto begun = std::chrono::steady_clock::now();
  std::thread other{[&wake] { wake.stop(); }};
  Wake::Why why = wake.wait(-1, 20s);
  other.join();
  EXPECT_EQ(why, Wake::Why::kStop);
  why = wake.wait(-1, 20s);
  EXPECT_EQ(why, Wake::Why::kStop) << "for good";
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 10s);
}

TEST(Wake, EndsWithTheTimeout) {
  const Wake wake;
  EXPECT_EQ(wake.wait(-1, 1ms), Wake::Why::kTimeout);
  EXPECT_EQ(wake.wait(-1, -5s), Wake::Why::kTimeout);
}

}  // namespace
}  // namespace darwinop::v4l2
