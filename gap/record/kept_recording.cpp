#include "gap/record/kept_recording.hpp"

#include <optional>

#include "core/text/formatted.hpp"
#include "experiments/logs/date.hpp"
#include "gap/case/body/parse_body_case.hpp"

namespace darwinop::gap {

double beginOf(const logs::Log& recording, const PlannedRecording& plan, const std::string& twin) {
  const auto refuse = [&](const std::string& why) -> BadInput {
    return BadInput{recording.file + ": " + why + "; delete it, or give another folder with --out"};
  };
  if (!recording.recording || !recording.complete) throw refuse("it is not a complete recording");
  if (recording.headValue("experiment").value_or("") != plan.experiment)
    throw refuse("it is not a recording of the experiment " + plan.experiment);
  const std::string robot = robotOf(recording);
  if (twin.empty() ? robot.starts_with(kTwinInHead) : robot != twin) throw refuse(messages::kOfAnotherRobot + robot);
  const std::optional<double> date = logs::dateOf(recording);
  if (!date) throw refuse("its date is missing");
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
