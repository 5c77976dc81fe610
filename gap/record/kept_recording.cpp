#include "gap/record/kept_recording.hpp"

#include <optional>

#include "core/text/formatted.hpp"
#include "experiments/logs/date.hpp"
#include "gap/case/body/parse_body_case.hpp"

namespace darwinop::gap {
namespace {

BadInput refused(const logs::Log& recording, const std::string& why) {
  return BadInput{recording.file + ": " + why + "; delete it, or give another folder with --out"};
}

}  // namespace

double beginOf(const logs::Log& recording, const PlannedRecording& plan, const std::string& twin) {
  const auto refuse = [&](const std::string& why) { return refused(recording, why); };
  if (!recording.recording || !recording.complete) throw refuse("it is not a complete recording");
  if (recording.headValue("experiment").value_or("") != plan.experiment)
    throw refuse("it is not a recording of the experiment " + plan.experiment);
  const std::string robot = robotOf(recording);
  if (isOtherRobot(robot, twin)) throw refuse(messages::kOfAnotherRobot + robot);
  return dateIn(recording);
}

bool isOtherRobot(const std::string& robot, const std::string& twin) {
  return twin.empty() ? robot.starts_with(kTwinInHead) : robot != twin;
}

double dateIn(const logs::Log& recording) {
  const std::optional<double> date = logs::dateOf(recording);
  if (!date) throw refused(recording, "its date is missing");
  return *date;
}

std::string robotOf(const logs::Log& recording) {
  return recording.headValue("model").value_or("");
}

double sessionAge(double first_s, double last_s, double now_s) {
  if (now_s < last_s) throw BadInput(messages::kClockSetBack);
  return now_s - first_s;
}

std::string pauseText(double pause_s) {
  constexpr double kOneSession = 3600;  // s: servos are cold again long before
  if (pause_s <= kOneSession) return {};
  return text::formatted("the last recording began %.0f", pause_s / 60) + messages::kAnotherSession;
}

}  // namespace darwinop::gap
