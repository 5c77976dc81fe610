// Compares a robot with its twin while it runs: residuals (robot minus twin) of joints and inertial sensor, cycle by
// cycle. docs/window.md.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gap/live/residual_window.hpp"
#include "gap/live/twin_replica.hpp"
#include "twin/body/imu_axes.hpp"

namespace darwinop::gap::live {

enum class LiveState : std::uint8_t {
  kNoData,     // no robot, or its board does not reply
  kOnItsSide,  // a twin on the floor cannot be put there
  kSettling,   // the twin was just put into the measured pose, or will be; or safety moves the robot
  kComparing,
  kFailed  // the simulation has stopped
};

/// Why the twin was put into the measured pose.
enum class Resync : std::uint8_t {
  kBegin,      // first cycle
  kGap,        // too many cycles are missing
  kSilence,    // the board replies again
  kTorque,     // a joint got torque
  kTurned,     // robot or twin has fallen or was turned
  kNewRuntime  // cycles count from 1 again
};
inline constexpr std::size_t kResyncs = 6;

/// Word for programs: "comparing", "gap".
std::string_view name(LiveState state);
std::string_view name(Resync reason);

struct LiveReport {
  LiveState state = LiveState::kNoData;
  std::string error;               // kFailed: why
  std::optional<Resync> resynced;  // the last one
  std::optional<Axes> up;          // of the twin's trunk when it was placed
  std::uint64_t cycles = 0;        // taken
  std::uint64_t compared = 0;      // of these
  std::uint64_t missing = 0;       // not taken: gaps in the number of the cycle
  std::array<std::uint64_t, kResyncs> resyncs{};
  std::bitset<kJoints> driven, silent;  // in the last cycle; others are not compared
  bool are_gains_known = false;
  std::array<SignalResidual, kJoints> position_rad, load;  // load: fraction of the maximum torque
  std::array<SignalResidual, 3> gyro_rad_s, accel_m_s2;
};

class LiveComparison {
 public:
  /// `period_s`: of the robot's loop. Throws std::runtime_error.
  LiveComparison(twin::Model model, Support support, double period_s);

  /// One cycle after the other; the same one again has no effect.
  void take(const LiveCycle& cycle);
  [[nodiscard]] LiveReport report() const;

 private:
  void noteOrder(const Sensors& seen);
  void noteTorque(const Sensors& seen);
  void noteTurn(double dt_s);
  void place(const LiveCycle& cycle);
  void compare(const Sensors& seen, const BodyState& twin);

  twin::TrunkAcceleration acceleration_;  // robot and twin have a sensor as the model describes it
  TwinReplica twin_;
  LiveReport status_;  // without the residuals
  std::uint64_t last_cycle_ = 0;
  double last_time_s_ = 0, settled_at_s_ = 0, turned_s_ = 0;
  std::optional<Resync> wanted_ = Resync::kBegin;
  std::array<double, kJoints> measured_rad_{};
  TrunkDirection robot_up_, twin_up_;
  std::size_t cycles_of_turn_;
  std::vector<ResidualWindow> position_, load_, gyro_, accel_;
};

}  // namespace darwinop::gap::live
