// Converts a reply of the 2013 protocol, without the extension, to a sensor image.
#include "remote/client/legacy_sensors.hpp"

#include "core/registers.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop::remote {
namespace {

constexpr Register kOldAccelLaw = find(kCm730, "accel_x");  // same conversion for all three axes
constexpr Register kOldGyroLaw = find(kCm730, "gyro_x");

template <class Unit>
Unit fromCount(std::int32_t count, const Register& law) {
  return count == kNoValue ? Unit{} : Unit{(count - law.zero) * law.scale};
}

}  // namespace

void requestAllSensors(Request& request) {
  request.accelerometer = request.gyro = true;
  for (std::uint8_t i = 0; i < kJoints; ++i) {
    (void)request.positions.add(i);
    (void)request.torques.add(i);
  }
}

void takeLegacyReply(const Reply& reply, Sensors& seen) {
  seen.safety.state = State::kDriven;
  BoardSensors& board = seen.board;
  board.buttons_known = false;
  if (reply.gyro[0] != kNoValue) board.motion.received();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    board.accelerometer[axis] = fromCount<MeterPerSec2>(reply.accelerometer[axis], kOldAccelLaw);
    board.gyro[axis] = fromCount<RadPerSec>(reply.gyro[axis], kOldGyroLaw);
  }
  for (std::size_t i = 0; i < kJoints; ++i) {
    JointSensors& joint = seen.joint[i];
    joint.position = Rad{measuredFromWire(reply.positions[i])};
    joint.load = -measuredFromWire(reply.torques[i]) / kMaxTorqueNm;  // 2013 convention: clockwise is positive
    if (joint.position.known()) joint.motion.received();
  }
}

}  // namespace darwinop::remote
