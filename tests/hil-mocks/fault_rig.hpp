// A virtual robot with faults: sends bytes as hex and returns all replies.
#pragma once

#include "bench.hpp"
#include "hil-mocks/virtual_robot.hpp"

namespace darwinop::hil {

inline InjectedFault faultOf(FaultKind kind, Nanos at, Nanos lasts) {
  InjectedFault fault;
  fault.kind = kind;
  fault.at = at;
  fault.lasts = lasts;
  return fault;
}

/// The neck is unplugged from 10 to 40 ms, and boots for 100 ms then.
inline InjectedFault neckWithoutSupply() {
  InjectedFault dead = faultOf(FaultKind::kDead, 10ms, 30ms);
  dead.joints.set(index(Joint::kNeck));
  dead.boot = 100ms;
  return dead;
}

struct Robot : VirtualRobot {
  explicit Robot(std::uint64_t seed = 1) : VirtualRobot{Bench::powered(), seed} {}

  std::string send(const std::string& hex, Nanos wait = 5ms) {
    receive(bytesOf(hex), now());
    advance(now() + wait);
    std::string all;
    for (; !output().empty(); output().pop()) all += (all.empty() ? "" : " | ") + hexOf(output().front().bytes());
    return all;
  }
  std::string readServo(const std::string& id, const std::string& address) {
    return send(withChecksum("FF FF " + id + " 04 02 " + address + " 01"));
  }
};

inline constexpr const char* kNeckPing = "FF FF 13 02 01 E9";

}  // namespace darwinop::hil
