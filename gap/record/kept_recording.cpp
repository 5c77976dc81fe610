#include "gap/record/kept_recording.hpp"

#include <ctime>

#include "gap/case/body/parse_body_case.hpp"

namespace darwinop::gap {

double beginOf(const logs::Log& recording, const PlannedRecording& plan, RecordedRobot robot) {
  const auto refuse = [&](const std::string& why) -> BadInput {
    return BadInput{recording.file + ": " + why + "; delete it, or give another folder with --out"};
  };
  if (!recording.recording || !recording.complete) throw refuse("it is not a complete recording");
  if (recording.headValue("experiment").value_or("") != plan.experiment)
    throw refuse("it is not a recording of the experiment " + plan.experiment);
  const bool is_twin = recording.headValue("model").value_or("").starts_with(kTwinInHead);
  if (is_twin != (robot == RecordedRobot::kSimulated)) throw refuse("it is of another robot than --robot names");
  std::tm begin{};
  const std::string date = recording.headValue("date").value_or("");
  if (strptime(date.c_str(), "%Y-%m-%dT%H:%M:%SZ", &begin) == nullptr) throw refuse("its date is missing");
  return static_cast<double>(timegm(&begin));
}

}  // namespace darwinop::gap
