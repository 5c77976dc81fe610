// Earlier recordings of the robot that is recorded: those that are kept, and the session that goes on.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <utility>

#include "experiments/logs/read_log.hpp"
#include "gap/record/kept_recording.hpp"
#include "gap_recorder.hpp"

namespace darwinop::gap {

namespace fs = std::filesystem;

void BodyRecorder::continueSession(double first_s, double last_s) {
  if (isSimulated()) return;  // its servos are cold again each time
  const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
  earlier_s_ = sessionAge(first_s, last_s, now.count());
  if (const std::string pause = pauseText(now.count() - last_s); !pause.empty()) std::cout << pause << '\n';
}

void BodyRecorder::keep(const std::vector<PlannedRecording>& plans) {
  std::vector<std::pair<const PlannedRecording*, double>> begins;  // s since 1970
  for (const PlannedRecording& plan : plans)
    if (fs::exists(fileOf(plan))) begins.emplace_back(&plan, beginOf(logs::readLog(fileOf(plan)), plan, twin_));
  if (begins.empty()) return;
  const auto [first, last] = std::ranges::minmax(begins, {}, &decltype(begins)::value_type::second);
  const double first_s = first.second;
  continueSession(first_s, last.second);
  for (const auto& [plan, begin_s] : begins) {
    const std::vector<std::string> problems = look(*plan, fileOf(*plan), isSimulated() ? 0 : begin_s - first_s);
    if (find(*plan) == nullptr) throw BadInput(problems.front());
    std::cout << plan->file << ": " << messages::kKept << '\n';
    for (const std::string& problem : problems) std::cout << "  " << problem << '\n';
  }
}

void BodyRecorder::goOn(const BodyCase& so_far) {
  std::vector<logs::Log> recordings;
  for (const BodyLog& log : so_far.logs)
    recordings.push_back(logs::readLog((fs::path{given_.out} / log.file).string()));
  const logs::Log& first = recordings.front();
  robot_ = robotOf(first);
  if (isOtherRobot(robot_, twin_))
    throw BadInput(first.file + ": " + messages::kOfAnotherRobot + robot_ + messages::kTakeItsRobot);
  if (isSimulated()) return;
  std::vector<double> begins_s(recordings.size());
  std::ranges::transform(recordings, begins_s.begin(), dateIn);
  const double used_s = std::max(0.0, so_far.logs.front().from_s - first.seconds(0));  // from_s may be -inf
  continueSession(begins_s.front() + used_s - so_far.logs.front().session_start_s, std::ranges::max(begins_s));
}

}  // namespace darwinop::gap
