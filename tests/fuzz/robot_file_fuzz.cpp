// robot.ini: an error message, or a configuration that is safe to drive with.
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "connect/robot_file.hpp"

namespace {

using namespace darwinop;

void require(bool holds) {
  if (!holds) std::abort();
}

void requireSane(const connect::RobotFile& robot) {
  require(robot.serialPort().starts_with('/'));
  const Nanos period = robot.period.value_or(connect::kUsualPeriod);
  require(period >= std::chrono::milliseconds{8} && period <= std::chrono::milliseconds{1000});
  require(!connect::describe(robot).empty());
  const safety::Config config = connect::safetyOn(robot, {}, "config.ini");
  config.check();
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    require(robot.offsets.servoTicks(joint, config.range[i].low) >= row(joint).low);
    require(robot.offsets.servoTicks(joint, config.range[i].high) <= row(joint).high);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    requireSane(connect::parseRobotFile({reinterpret_cast<const char*>(data), size}, "robot.ini"));
  } catch (const std::runtime_error& refused) {
    require(!std::string_view{refused.what()}.empty());
  }
  return 0;
}
