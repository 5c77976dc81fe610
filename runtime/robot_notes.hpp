// State that must survive a killed loop: two marker files, which survive the process but not a reboot.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/sensors.hpp"
#include "runtime/names.hpp"

namespace darwinop::runtime {

/// Used by the process that runs the loop: the daemon, or the supervisor's rescue. Not in the loop's thread: it opens
/// files.
class RobotNotes {
 public:
  /// Reads the markers of an earlier process.
  explicit RobotNotes(const RuntimeFiles& files);

  /// A person released the robot, and no person has acted since: a new loop must not drive it.
  [[nodiscard]] bool released() const { return released_.exists; }
  /// Joints were held, and not all were seen limp since. If a new loop then finds servo power off, RESET was pressed
  /// under torque (safety::Config::held_before).
  [[nodiscard]] bool held() const { return held_.exists; }

  /// Call with every image of the loop, or every few images.
  void update(const Sensors& seen);

  /// Removes the markers: a person has acted while no loop ran.
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
