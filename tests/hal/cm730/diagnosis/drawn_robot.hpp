// A virtual robot with drawn harmless differences and at most one drawn fault, and what the doctor must name.
#pragma once

#include <bitset>
#include <optional>
#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "hal/cm730/bridged_line.hpp"
#include "hal/cm730/diagnosis/fault_naming.hpp"
#include "hal/cm730/diagnosis/probe.hpp"
#include "hil-mocks/plain_body.hpp"
#include "hil-mocks/virtual_robot.hpp"

namespace darwinop::cm730 {

/// What a draw decides.
struct RobotDraw {
  hil::BoardOptions board;
  std::vector<hil::InjectedFault> script;
  std::array<double, kJoints> position_rad{};
  double load = 0;  // of each servo under torque
  bool torque_on = false;
  // The line between program and board.
  Nanos latency{1ms}, least_delay{0}, most_delay{0};
  double damaged_per_byte = 0;
  Nanos other_period{0};  // of another program that polls the robot; 0: none

  // To be named first.
  std::optional<BusFault> fault;  // empty: nothing
  std::bitset<kJoints> joints;
  std::optional<Joint> other;
};

/// What the virtual robot does (kBusFaultTable has it in words), and what has to be named.
struct DrawnFault {
  std::string_view name;
  BusFault named;
  void (*draw)(RobotDraw&, Rng&);  // sets the fault, its place and its size
};
/// Ends with the faults that were added to the twenty that the doctor has to name.
extern const std::vector<DrawnFault> kDrawnFaults;

/// Temperatures, voltage, pose, power, torque and USB timing of a healthy robot.
RobotDraw drawHealthy(Rng& rng);
RobotDraw drawFault(const DrawnFault& fault, Rng& rng);

struct DoctorResult {
  ProbeReport report;
  std::vector<NamedFault> named;
};
/// What the doctor does after it has opened the port, in simulated time.
DoctorResult examine(const RobotDraw& drawn, std::uint64_t seed);

}  // namespace darwinop::cm730
