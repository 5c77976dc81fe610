// State that must survive a killed loop: two marker files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/sensors.hpp"
#include "runtime/marker_file.hpp"
#include "runtime/names.hpp"

namespace darwinop::runtime {

/// Used by the process that runs the loop: the daemon, or the supervisor's rescue. Not in the loop's thread: it opens
/// files.
class RobotNotes {
 public:
  /// Reads the markers of an earlier process. What another user has put in the place of one counts as set.
  explicit RobotNotes(const RuntimeFiles& files);

  /// A person released the robot, and no person has acted since: a new loop must not drive it.
  [[nodiscard]] bool released() const;
  /// Joints were held, and not all were seen limp since. If servo power is then found off, RESET was pressed under
  /// torque: noteServoPowerOff(), and safety::Config::held_before for what the loop itself still sees.
  [[nodiscard]] bool held() const { return held_.isSet(); }

  /// False: a release would be lost with this process.
  [[nodiscard]] bool kept() const { return released_.kept() && held_.kept(); }
  /// What was found in the place of a marker, with a remedy; empty: nothing unexpected.
  [[nodiscard]] std::string warning() const;

  /// Call with every image of the loop, or every few images.
  void update(const Sensors& seen);

  /// At a normal end: removes the markers that are not set.
  void tidy() {
    released_.removeIfClear();
    held_.removeIfClear();
  }
  /// Call when servo power is found off, before it is switched on: with held() the robot counts as released, also for a
  /// later process, should this one not come to drive.
  static void noteServoPowerOff(const RuntimeFiles& files);
  /// Removes the markers: a person has acted while no loop ran.
  static void forget(const RuntimeFiles& files);

 private:
  MarkerFile released_, held_;
  std::optional<std::uint64_t> limp_since_;  // cycle number
};

}  // namespace darwinop::runtime
