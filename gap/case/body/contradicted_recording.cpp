#include "gap/case/body/contradicted_recording.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "core/text/formatted.hpp"
#include "gap/case/body/clamped_trunk.hpp"
#include "gap/case/body/exchanged_columns.hpp"
#include "gap/case/median.hpp"
#include "gap/case/wire_schedule.hpp"

namespace darwinop::gap {
namespace {

constexpr double kBeyondRange = 0.35;  // rad: no offset of a joint that was assembled by its marks is as large
constexpr double kOtherBattery_v = 2;  // V: no battery that still drives the robot sags as far
constexpr double kTurned = 0.2;        // rad: noise of a gyroscope adds up to a tenth of it

std::string nameOf(std::size_t joint) {
  return std::string{kJointTable[joint].name};
}

void refuseGoalsBeyondRange(const BodyCase& given, std::size_t log, std::size_t joint) {
  const Trajectory& rows = given.joint(log, joint);
  const double low = radFromTicks(kJointTable[joint].low).value - kBeyondRange,
               high = radFromTicks(kJointTable[joint].high).value + kBeyondRange;
  for (std::size_t row = 0; row < rows.rows(); ++row)
    if (rows.torque_on[row] != 0 && !(rows.goal_rad[row] >= low && rows.goal_rad[row] <= high))
      throw BadInput(given.logs[log].file + ", line " + std::to_string(rows.lines[row]) + ": " + nameOf(joint) +
                     ".commanded is " + text::formatted("%.2f", rows.goal_rad[row]) + messages::kGoalBeyondRange);
}

void refuseLimpAtStart(const BodyCase& given, std::size_t log, std::size_t joint) {
  const Trajectory& rows = given.joint(log, joint);
  if (rows.torque_on.front() == 0 && std::ranges::find(rows.torque_on, 1) != rows.torque_on.end())
    throw BadInput(given.logs[log].file + ": " + nameOf(joint) + messages::kLimpAtStart);
}

void refuseOtherBattery(const BodyLog& log) {
  if (const double board_v = medianOf(log.board_v); std::abs(board_v - log.battery_v) > kOtherBattery_v)
    throw BadInput(log.file + text::formatted(": `battery_V` is %.1f", log.battery_v) + messages::kOtherBattery +
                   text::formatted("%.1f V; correct the one that is wrong", board_v));
}

void checkTrunk(const BodyLog& log, std::vector<std::string>& warnings) {
  if (!log.up) return;
  if (const double turn = greatestTurn(log); turn > kTurned)
    throw BadInput(log.file + text::formatted(": the trunk turns by %.2f", turn) + messages::kTrunkTurns);
  if (const double rate = greatestRate(log.gyro_rad_s); rate > kClampedRate)
    warnings.push_back(log.file + text::formatted(": the trunk turns by %.2f", rate) + messages::kTrunkShakes);
}

}  // namespace

void refuseContradicted(BodyCase& given, std::size_t log) {
  refuseOtherBattery(given.logs[log]);
  checkTrunk(given.logs[log], given.warnings);
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    if (given.is_absent[joint]) continue;
    refuseLimpAtStart(given, log, joint);
    refuseGoalsBeyondRange(given, log, joint);
  }
  refuseExchangedColumns(given, log);
}

void refuseOtherRobot(const logs::Log& first, const logs::Log& other, std::vector<std::string>& warnings) {
  for (const char* key : {"robot", "model"}) {
    const std::optional<std::string> expected = first.headValue(key), found = other.headValue(key);
    if (!expected || !found || *expected == *found) continue;
    const std::string text = other.file + ": it is of " + *found + ", " + first.file + " of " + *expected;
    // The "model" of a physical robot is a port and what it has found: either may have changed.
    if (std::string_view{key} == "robot" || isInLockstep(first) || isInLockstep(other))
      throw BadInput(text + messages::kOtherRobotInHead + "; leave out the recordings of the other one");
    warnings.push_back(text + messages::kOtherRobotInHead);
  }
}

}  // namespace darwinop::gap
