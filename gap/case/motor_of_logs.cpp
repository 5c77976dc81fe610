// The one motor of a folder of BAM logs.
#include <algorithm>
#include <map>

#include "gap/case/bam_log.hpp"
#include "gap/case/known_servos.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNearlyAllLogs = 0.9;  // a few of another motor are in the folder by mistake

/// "mx106 (480), mx64 (2)"
std::string namesOf(const std::map<std::string, std::size_t>& motors) {
  std::string text;
  for (const auto& [name, logs] : motors)
    text += (text.empty() ? "" : ", ") + (name.empty() ? "no name" : name) + " (" + std::to_string(logs) + ")";
  return text;
}

}  // namespace

std::string keepOneMotor(const std::optional<std::string>& declared, const std::string& folder,
                         std::vector<BamLog>& logs, std::vector<std::string>& notes) {
  std::map<std::string, std::size_t> motors;
  for (const BamLog& one : logs) ++motors[motorName(one.motor)];
  const auto most = std::ranges::max_element(motors, {}, [](const auto& one) { return one.second; });
  const std::string wanted = declared ? motorName(*declared) : most->first;
  if (motors.size() == 1) return wanted;
  const bool is_clear = declared
                            ? motors.contains(wanted)
                            : static_cast<double>(most->second) >= kNearlyAllLogs * static_cast<double>(logs.size());
  if (!is_clear) throw BadInput(folder + ": " + messages::kSeveralMotors + namesOf(motors));
  std::erase_if(logs, [&](const BamLog& one) {
    const std::string name = motorName(one.motor);
    return name != wanted && !(declared && name.empty());
  });
  motors.erase(wanted);
  if (declared) motors.erase("");
  if (!motors.empty()) notes.push_back(messages::kOtherMotors + namesOf(motors));
  return wanted;
}

}  // namespace darwinop::gap
