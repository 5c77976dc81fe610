// [Safety] and [Limits] of a controller for a robot over TCP: refused, as the protocol cannot transmit them.
#include <gmock/gmock.h>

#include <stdexcept>
#include <string>

#include "connect/connect.hpp"
#include "connect/messages.hpp"

namespace darwinop::connect {
namespace {

using testing::HasSubstr;

/// Message of connect(); no server listens there.
std::string refusalOf(const safety::Config& config) {
  ConnectRequest request;
  request.setting = "tcp://127.0.0.1:1";
  request.safety = config;
  request.config_file = "walk/config.ini";
  try {
    (void)connect(request);
    return "accepted";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(RobotOverTcp, RefusesSafetyAndLimitsOfAController) {
  safety::Config safety;
  safety.set("Safety", "hot", "65");
  EXPECT_THAT(refusalOf(safety), HasSubstr(std::string{"walk/config.ini"} + messages::kNoSafetyOverTcp));
  safety::Config limits;
  limits.range[18].low = Rad{-0.5};
  EXPECT_THAT(refusalOf(limits), HasSubstr(std::string{"walk/config.ini"} + messages::kNoSafetyOverTcp));
}

}  // namespace
}  // namespace darwinop::connect
