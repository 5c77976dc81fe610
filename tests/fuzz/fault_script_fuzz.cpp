// Fault script: an error message, or a script that runs on a robot in use, which answers once its faults have ended.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/registers.hpp"
#include "hil-mocks/fault_script.hpp"
#include "hil-mocks/virtual_robot.hpp"

namespace {

using namespace darwinop;
using std::chrono::milliseconds;

/// A goal for every servo, which switches its torque on, and a reading of all devices.
void cycle(hil::VirtualRobot& robot, std::uint8_t goal) {
  std::vector<std::uint8_t> goals{servo::kGoalPosition, 2}, all{0, 30, kBoardId, 24};
  for (std::uint8_t id = 1; id <= kJoints; ++id) {
    goals.insert(goals.end(), {id, goal, 8});
    all.insert(all.end(), {6, id, servo::kPresentPosition});
  }
  std::array<std::uint8_t, kMaxFrame> frame;
  robot.receive(encodeInstruction(frame, kBroadcastId, Instruction::kSyncWrite, goals), robot.now());
  robot.receive(encodeInstruction(frame, kBroadcastId, Instruction::kBulkRead, all), robot.now());
  robot.advance(robot.now() + milliseconds{16});
  while (!robot.output().empty()) robot.output().pop();
}

void mustAnswer(hil::VirtualRobot& robot) {
  robot.faults().clear();
  robot.advance(robot.now() + milliseconds{500});
  while (!robot.output().empty()) robot.output().pop();
  std::array<std::uint8_t, 8> ping;
  robot.receive(encodePing(ping, kBoardId), robot.now());
  robot.advance(robot.now() + milliseconds{10});
  if (robot.output().empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<hil::InjectedFault> faults;
  try {
    faults = hil::parseFaultScript({reinterpret_cast<const char*>(data), size}, "fuzz");
  } catch (const std::runtime_error&) {
    return 0;
  }
  hil::BoardOptions options;
  options.servo_power = true;
  options.body_step = milliseconds{16};
  hil::VirtualRobot robot{options};
  robot.faults().add(faults);
  for (std::uint8_t i = 0; i < 125; ++i) cycle(robot, i);
  mustAnswer(robot);
  return 0;
}
