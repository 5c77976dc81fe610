// The bus of a robot on a serial port, opened and checked.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/cm730/diagnosis/permitted.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"
#include "hal/cm730/diagnosis/start_policy.hpp"
#include "hal/cm730/imu_correction.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "hal/servo_bus.hpp"
#include "safety/config.hpp"

namespace darwinop::connect {

/// Of a loop on a serial port. Shorter: a cycle takes up to 5.5 ms on the bus. Longer: servos and buttons are watched a
/// reading at a time; with 50 ms MODE, held for 0.25 s, is read five times, and a servo that has restarted is found
/// within 1.4 s.
inline constexpr std::chrono::milliseconds kShortestPeriod{8}, kLongestPeriod{50};

/// Configuration of a robot on a serial port.
struct SerialRobot {
  std::string port;
  Nanos period{16'000'000};
  safety::Config safety{};
  cm730::JointOffsets offsets{};
  cm730::Permitted permitted{};
  cm730::ImuCalibration imu{};
  /// Called if servo power is off, before it is switched on: the loop on the opened bus cannot see it any more.
  std::function<void()> before_servo_power{};
};

/// An open bus with its line.
struct OpenedBus {
  std::unique_ptr<ServoBus> bus;
  /// SerialRobot::safety, restricted to the servos' own angle limits and without joints that cannot be driven. A loop
  /// on this bus must use it.
  safety::Config safety{};
  std::string description;  // "/dev/ttyUSB0 (CM-730 firmware 19, 20 servos)"
  std::string warnings;     // findings of the start-up probe, one per line; empty: none
};

/// Range of goals that each servo can receive with these settings, in servo ticks.
cm730::TickRanges goalTicks(const safety::Config& safety, const cm730::JointOffsets& offsets);

/// Opens a serial device and checks the robot on it; hal/cm730/diagnosis/start_policy.hpp defines what is refused.
/// Throws std::runtime_error with error and remedy; cm730::NotReady if retrying is useful.
OpenedBus openSerialBus(const SerialRobot& robot, cm730::Purpose purpose = cm730::Purpose::kDrive);

}  // namespace darwinop::connect
