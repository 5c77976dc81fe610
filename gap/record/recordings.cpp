#include "gap/record/recordings.hpp"

#include <algorithm>

#include "core/json/json_text.hpp"
#include "core/text/formatted.hpp"
#include "gap/case/fields.hpp"

namespace darwinop::gap {
namespace {

constexpr const char* kUpright =
    "Clamp the trunk in the stand, upright, in the start pose. All limbs must be free in the air, with an arm's length "
    "of room. Set the direction with a spirit level: half a degree is 0.09 m/s2.";
constexpr const char* kAgain = "Leave everything as it is: the same motion again shows what varies from run to run.";
constexpr const char* kOnLeft =
    "Turn the stand by 90 degrees: the robot lies on its left side, its right arm is on top.";
constexpr const char* kFaceDown =
    "Turn the stand: face down, back on top. In this recording the arms and the head fall limp for a second; keep the "
    "room below them free.";
constexpr const char* kOnRight = "Turn the stand: the robot lies on its right side, its left arm is on top.";
constexpr const char* kStanding =
    "Take the robot out of the stand and set it on a level floor, in the start pose. It stands up: hold it by its "
    "handle, without pulling.";

Json entryOf(const MadeRecording& one) {
  Json log{{"file", one.plan.file}, {"role", one.plan.held_out ? "held_out" : "fit"}, {"setup", name(one.plan.setup)}};
  if (one.plan.up) log["up"] = *one.plan.up;
  log["from_s"] = one.from_s, log["to_s"] = one.to_s;
  log["session_s"] = one.session_s;
  if (!one.plan.repeat_of.empty()) log["repeat_of"] = one.plan.repeat_of;
  log["battery_V"] = one.battery_v;
  return log;
}

std::string textOf(const Json& of_case) {
  return jsonText(of_case, 1) + "\n";
}

}  // namespace

PlannedRecording addedRecording(const std::string& file, const std::string& experiment, const Axes& up) {
  const std::string placing = text::formatted(
      "Clamp the trunk in the stand so that %.3g left, %.3g up, %.3g forward in its frame points up. All limbs must be "
      "free in the air, with an arm's length of room.",
      up[0], up[1], up[2]);
  return {file, experiment, BodySetup::kClamped, up, placing, false, ""};
}

std::vector<PlannedRecording> plannedRecordings(bool with_floor) {
  constexpr auto kClamped = BodySetup::kClamped;
  std::vector<PlannedRecording> out{
      {"upright.csv", "body_sines", kClamped, Axes{0, 1, 0}, kUpright, false, ""},
      {"upright_again.csv", "body_sines", kClamped, Axes{0, 1, 0}, kAgain, false, "upright.csv"},
      {"left_side.csv", "body_triangles", kClamped, Axes{-1, 0, 0}, kOnLeft, false, ""},
      {"face_down.csv", "body_release", kClamped, Axes{0, 0, -1}, kFaceDown, false, ""},
      {"right_side.csv", "body_chirp", kClamped, Axes{1, 0, 0}, kOnRight, true, ""}};
  if (with_floor) out.push_back({"standing.csv", "body_stand", BodySetup::kFloor, std::nullopt, kStanding, false, ""});
  return out;
}

std::string bodyCaseJson(const std::string& name, const std::string& model, RecordedRobot robot,
                         const std::vector<MadeRecording>& made) {
  Json trust{{"exact", true}};
  // Masses and servos differ by as much as makers allow; dry friction by half from joint to joint; the sensor's biases
  // are those of its data sheet, warmed up. A stand is set with a spirit level, to about half a degree.
  if (robot == RecordedRobot::kPhysical)
    trust = {{"body.mass", 0.03},           {"body.com_m", 0.003},        {"servo", 0.05},
             {"servo.armature", 0.2},       {"servo.duty_per_kp", 0.03},  {"friction", 0.5},
             {"imu.gyro_bias_rad_s", 0.05}, {"imu.accel_bias_m_s2", 0.3}, {std::string{kUpSigma}, 0.01}};
  Json logs = Json::array();
  for (const MadeRecording& one : made) logs.push_back(entryOf(one));
  return textOf(Json{{"case", name}, {"family", "body"}, {"model", model}, {"trust", trust}, {"logs", logs}});
}

std::string withEntries(const std::string& text, const std::string& file, const std::vector<MadeRecording>& made) {
  Json of_case = parseJson(text, file);
  Json& logs = of_case["logs"];
  for (const MadeRecording& one : made)
    if (std::ranges::none_of(logs, [&](const Json& log) { return log["file"] == one.plan.file; }))
      logs.push_back(entryOf(one));
  return textOf(of_case);
}

}  // namespace darwinop::gap
