// Builds a reply from a sensor image and the newest picture.
#include "remote/server/reply_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/registers.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop::remote {
namespace {

constexpr Register kAccelLaw = find(kCm730, "accel_x");  // same conversion for all three axes
constexpr Register kGyroLaw = find(kCm730, "gyro_x");

/// Raw count of the board.
std::int32_t countOf(double si, const Register& law) {
  return cut(std::round(si / law.scale + law.zero));
}

void note(std::size_t device, Freshness freshness, StaleValues& stale) {
  if (!freshness.ever())
    stale.never.set(device);
  else if (freshness.stale())
    stale.old.set(device);
}

template <class Value>
std::int32_t measured(std::uint8_t index, const Sensors& seen, StaleValues& stale, Value value) {
  if (index >= kJoints) return 0;
  note(index, seen.joint[index].motion, stale);
  return value(seen.joint[index]);
}

}  // namespace

Reply makeReply(const Request& request, const Sensors& seen, std::span<const std::uint8_t> jpeg, StaleValues& stale) {
  Reply reply;
  if (request.accelerometer || request.gyro) note(StaleValues::kBoard, seen.board.motion, stale);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    reply.accelerometer[axis] = countOf(seen.board.accelerometer[axis].value, kAccelLaw);
    reply.gyro[axis] = countOf(seen.board.gyro[axis].value, kGyroLaw);
  }
  reply.jpeg = jpeg;
  for (const std::uint8_t index : request.positions)
    (void)reply.positions.add(measured(
        index, seen, stale, [](const JointSensors& joint) { return wireFromMeasuredPosition(joint.position.value); }));
  for (const std::uint8_t index : request.torques)
    (void)reply.torques.add(measured(index, seen, stale, [](const JointSensors& joint) {
      return wireFromMeasuredTorque(-joint.load * kMaxTorqueNm);  // 2013 convention: clockwise is positive
    }));
  return reply;
}

void addExtension(Reply& reply, const Extension& request, const Sensors& seen, const JpegPicture& newest, Nanos held) {
  const auto microseconds = [](Nanos time) {
    const auto us = std::chrono::duration_cast<std::chrono::microseconds>(time).count();
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(us, 0, std::numeric_limits<std::uint32_t>::max()));
  };
  ReplyExtension& extension = reply.extension.emplace();
  extension.held_us = microseconds(held);
  extension.seen = &seen;
  extension.picture = static_cast<std::uint32_t>(newest.sequence);
  extension.picture_age_us = microseconds(newest.age);
  extension.holds_picture = extension.picture != 0 && extension.picture == request.picture;
  if (extension.holds_picture) reply.jpeg = {};
}

}  // namespace darwinop::remote
