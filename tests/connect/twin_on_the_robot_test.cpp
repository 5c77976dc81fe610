// Programs for the robot know the twin by name only.
#include <gmock/gmock.h>

#include <stdexcept>

#include "connect/connect.hpp"

namespace darwinop::connect {
namespace {

TEST(TwinOnTheRobot, IsRefusedWithASentence) {
  ConnectRequest request;
  request.setting = "twin";
  try {
    connect(request);
    ADD_FAILURE() << "a static program has loaded a library";
  } catch (const std::runtime_error& refusal) {
    EXPECT_THAT(refusal.what(), testing::HasSubstr("'virtual'"));
  }
}

}  // namespace
}  // namespace darwinop::connect
