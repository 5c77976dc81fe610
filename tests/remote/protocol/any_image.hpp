// Arbitrary sensor images, rounded as on the wire.
#pragma once

#include <rapidcheck.h>

#include "core/sensors.hpp"

namespace darwinop::remote {

inline double anyReal() {
  return static_cast<double>(*rc::gen::arbitrary<float>());  // binary32, as on the wire
}
inline Freshness anyAge() {
  return {*rc::gen::inRange<std::uint32_t>(0, 256) == 255 ? Freshness::kNever
                                                          : *rc::gen::inRange<std::uint32_t>(0, 255)};
}
template <std::size_t N>
std::bitset<N> anyBits() {
  return std::bitset<N>{*rc::gen::arbitrary<std::uint32_t>() & ((1U << N) - 1U)};
}

inline Sensors anyImage() {
  using rc::gen::arbitrary;
  Sensors seen;
  seen.cycle = *arbitrary<std::uint64_t>();
  seen.time_ns = *arbitrary<std::int64_t>();
  seen.period_ns = *arbitrary<std::int64_t>();
  seen.slack_ns = *arbitrary<std::int64_t>();
  seen.overruns = *arbitrary<std::uint32_t>();
  for (JointSensors& joint : seen.joint) {
    joint.motion = anyAge();
    joint.polled = anyAge();
    joint.position = Rad{anyReal()};
    joint.load = anyReal();
    joint.temperature = Celsius{anyReal()};
    joint.torque_enabled = *arbitrary<bool>();
    joint.driven = *arbitrary<bool>();
    joint.commanded = Rad{anyReal()};
  }
  seen.board.motion = anyAge();
  seen.board.gyro[2] = RadPerSec{anyReal()};
  seen.board.buttons = *arbitrary<std::uint8_t>();
  seen.board.absent = *arbitrary<bool>();
  seen.board.buttons_known = *arbitrary<bool>();
  seen.board.voltage = Volt{anyReal()};
  seen.board.led_eye = *arbitrary<std::uint16_t>();
  seen.link.late_replies = *arbitrary<std::uint32_t>();
  seen.wire.bus_ns = *arbitrary<std::int64_t>();
  seen.safety.state = static_cast<State>(*rc::gen::inRange<int>(0, kStates));
  seen.safety.active = anyBits<kFaults>();
  seen.safety.worst = kFaultTable[*rc::gen::inRange<std::size_t>(0, kFaults)].fault;
  seen.safety.limit_hits[3] = *arbitrary<std::uint32_t>();
  seen.safety.controller_must_end = *arbitrary<bool>();
  seen.safety.tripped = anyBits<kJoints>();
  seen.silent = anyBits<kJoints>();
  return seen;
}

}  // namespace darwinop::remote
