#include "gap/record/recording_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/conversions.hpp"
#include "core/text/formatted.hpp"
#include "core/text/nearest.hpp"
#include "core/units.hpp"
#include "gap/case/body/body_check.hpp"
#include "gap/case/body/parse_body_case.hpp"
#include "gap/case/median.hpp"

namespace darwinop::gap {
namespace {

constexpr double kHeld = 1.0;                 // s before row 0, gap/plant/body/limb_roll_out.cpp
constexpr double kWrongSide = kPi / 6;        // rad: a stand turned by hand is off by a few degrees
constexpr double kSame = 0.75 * kRadPerTick;  // of a goal, beside rounding

bool isEmpty(const logs::Column& column) {
  return std::ranges::all_of(column.values, [](double value) { return std::isnan(value); });
}

struct GoalColumns {
  const std::vector<double>*asked, *sent;  // rad; sent: by the safety layer
};

/// Those of the joints that have a servo: the others are never commanded.
std::vector<std::optional<GoalColumns>> goalColumns(const logs::Log& recording) {
  std::vector<std::optional<GoalColumns>> out;
  for (const JointRow& joint : kJointTable) {
    const std::string name{joint.name};
    const logs::Column& sent = recording.column(name + ".commanded");
    out.push_back(isEmpty(sent) ? std::nullopt
                                : std::optional{GoalColumns{&recording.column(name + ".asked").values, &sent.values}});
  }
  return out;
}

/// The pose is asked for, and what is sent rests: limits of a robot's servos may keep it away from the pose.
/// `from`: first row of the rest.
bool isHeld(std::size_t row, std::size_t from, const experiments::Pose& pose,
            const std::vector<std::optional<GoalColumns>>& goals) {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    if (!goals[joint]) continue;
    const auto& [asked, sent] = *goals[joint];
    if (!(std::abs((*asked)[row] - pose[joint]) < kSame) || !(std::abs((*sent)[row] - (*sent)[from]) < kSame))
      return false;  // NaN: not driven
  }
  return true;
}

/// Its goals differ by more than a position that counts as motion.
bool isAskedToMove(const BodyCase& given, std::string_view joint) {
  constexpr double kMotion = 0.02;  // rad
  const std::vector<double>& goals = given.joint(0, index(findJoint(joint).value())).goal_rad;
  const auto [low, high] = std::ranges::minmax(goals);
  return high - low > kMotion;
}

/// Angle between the mean reading of the accelerometer and the model's, rad.
double misplacedBy(const BodyCase& given, const RestingImu& imu) {
  const std::vector<RestingReading> readings = restingReadings(given, ImuSensor::kAccelerometer);
  if (readings.empty()) return std::nan("");
  const Eigen::Vector3d expected = imu.reading(ImuSensor::kAccelerometer, readings.front().up),
                        mean = readings.front().mean;
  return std::acos(std::clamp(expected.dot(mean) / (expected.norm() * mean.norm()), -1.0, 1.0));
}

}  // namespace

void findUsedRows(const logs::Log& recording, const experiments::Pose& pose, double phases_s, MadeRecording& made) {
  const auto goals = goalColumns(recording);
  std::size_t from = 0, to = 0;
  const bool is_driven = std::ranges::any_of(goals, [](const auto& joint) { return joint.has_value(); });
  for (; is_driven && from < recording.rows(); from = std::max(to, from + 1)) {
    for (to = from; to < recording.rows() && isHeld(to, from, pose, goals);) ++to;
    if (to > from && recording.seconds(to - 1) - recording.seconds(from) >= kHeld) break;
  }
  if (!is_driven || from >= recording.rows())
    throw BadInput(recording.file +
                   ": the robot never held the setup pose for a second; is a controller limited by "
                   "config.ini or robot.ini? Record it again");
  const double held_until = recording.seconds(to - 1);
  made.from_s = held_until;
  for (std::size_t row = to; row-- > from;)
    if (recording.seconds(row) - recording.seconds(from) >= kHeld) made.from_s = recording.seconds(row);
  made.to_s = held_until + phases_s;
  made.session_s += made.from_s - recording.seconds(0);  // the clock is the computer's
  std::vector<double> volts;
  const logs::Column& board = recording.column("board.voltage");
  for (std::size_t row = from; row < to; ++row) volts.push_back(board.values[row]);
  made.battery_v = std::round(medianOf(volts) * 100) / 100;
  if (std::isnan(made.battery_v))
    throw BadInput(recording.file + ": the voltage of the board is missing; record it again");
}

std::vector<std::string> problemsOf(const logs::Log& recording, const std::string& model, const RestingImu& imu,
                                    const MadeRecording& made) {
  MadeRecording alone = made;
  alone.plan.held_out = false, alone.plan.repeat_of.clear();
  const CaseFiles files{.log = [&](const std::string&) { return recording; },
                        .model = [](const std::string& name) { return twin::readModel(twin::findModel(name)); }};
  const BodyCase given =
      parseBodyCase(bodyCaseJson("recording", model, RecordedRobot::kSimulated, {alone}), made.plan.file, files);
  const BodyLogCheck check = checkData(given).logs.front();
  std::vector<std::string> out = given.warnings;
  if (check.late_rows > 0 || given.logs.front().lost_rows > 0)
    out.push_back(text::formatted("%zu cycles are late or missing; end other programs on this computer",
                                  std::max(check.late_rows, given.logs.front().lost_rows)));
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    if (const std::string name{kJointTable[joint].name};
        given.is_absent[joint] && !isEmpty(recording.column(name + ".commanded")))
      out.push_back(name + messages::kDrivenNeverAnswers);
  if (std::string text = noReadingText(check); !text.empty()) out.push_back(std::move(text));
  std::vector<std::string_view> stuck = check.unmoved;
  std::erase_if(stuck, [&](std::string_view joint) { return !isAskedToMove(given, joint); });
  if (!stuck.empty())
    out.push_back(text::listed(stuck) + " did not move; check cable and torque of " +
                  (stuck.size() == 1 ? "that servo" : "these servos"));
  if (const double off = made.plan.up ? misplacedBy(given, imu) : 0; off > kWrongSide)
    out.push_back(
        text::formatted("gravity is off by %.0f degrees from where it was asked to be; is the robot placed as "
                        "described? If it is, keep the recording: the sensor's axes may be what is wrong",
                        off * 180 / kPi));
  return out;
}

}  // namespace darwinop::gap
