// What has to be known of the robot when a loop was killed. Two files that outlive the process, not the computer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/sensors.hpp"
#include "runtime/names.hpp"

namespace darwinop::runtime {

/// Kept by the process that runs the loop: the daemon, or the supervisor's rescue. Not from the loop's own thread: it
/// opens files.
class RobotNotes {
 public:
  /// Reads what an earlier process has left.
  explicit RobotNotes(const RuntimeFiles& files);

  /// A person released the robot, and no person has acted since: a loop that begins must not drive it.
  [[nodiscard]] bool released() const { return released_.exists; }
  /// Joints were held, and not all were seen limp since. A loop that begins and finds servo power off
  /// knows by this that RESET was pressed under torque (safety::Config::held_before).
  [[nodiscard]] bool held() const { return held_.exists; }

  /// For each image of the loop, or for one in a few.
  void update(const Sensors& seen);

  /// A person has acted while no loop was there.
  static void forget(const RuntimeFiles& files);

 private:
  struct Note {
    std::string path;
    bool exists;
    void set(bool wanted);
  };

  Note released_, held_;
  std::optional<std::uint64_t> limp_since_;  // cycle number
};

}  // namespace darwinop::runtime
