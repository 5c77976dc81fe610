// One entry of the list of logs in a case.json.
#include <array>
#include <limits>

#include "core/text/nearest.hpp"
#include "core/units.hpp"
#include "gap/case/baseline_keys.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

constexpr twin::NumberRule kRegister{"", 0, 16383};  // of the newest family; an MX-28 has 0 to 254
constexpr twin::NumberRule kSession{"s", 0, 1e7};
constexpr twin::NumberRule kClock{"s", -1e11, 1e11};  // Unix time is 1.8e9
constexpr twin::NumberRule kGoal{"rad", -100, 100};
constexpr twin::NumberRule kProfileSpeed{"rad/s", 0, 100};

/// Files of a case stand in its folder, so that it can be moved as a whole.
bool isInside(const std::string& name) {
  return !name.empty() && name.front() != '/' && name.find("..") == std::string::npos &&
         name.find('\0') == std::string::npos;
}

/// "slow_tri" of "fit_slow_tri_2.csv" is not for guessing; "fit" is what is left.
std::string kindOf(const std::string& file) {
  const std::string stem = file.substr(0, file.rfind('.'));
  const std::size_t end = stem.find_last_not_of("0123456789_-");
  return end == std::string::npos ? stem : stem.substr(0, end + 1);
}

std::optional<Joint> jointOf(Fields& entry) {
  if (!entry.has("joint")) return std::nullopt;
  std::vector<std::string_view> names;
  names.reserve(kJoints);
  for (const JointRow& row : kJointTable) names.push_back(row.name);
  const std::string name = entry.text("joint");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<Joint>(i);
  entry.fail("joint", "is not a joint; " + text::suggestion(name, names));
}

}  // namespace

std::string logFileIn(Fields& entry) {
  std::string file = entry.text("file");
  if (!isInside(file))
    entry.fail("file", std::string{messages::kBeyondFolder} + "; copy the log next to the case.json");
  return file;
}

EntryRole roleIn(Fields& entry) {
  constexpr std::array kRoles{EntryRole::kFit, EntryRole::kHeldOut, EntryRole::kValidation, EntryRole::kOther,
                              EntryRole::kHeldOut};
  return kRoles.at(entry.word("role", {"fit", "held_out", "validation", "other", "score"}, kRoles.size()));
}

LogEntry readLogEntry(Fields& entry, std::vector<std::string>& warnings) {
  LogEntry out{};
  out.head.file = logFileIn(entry);
  out.head.kind = entry.text("trajectory", kindOf(out.head.file));
  const EntryRole role = roleIn(entry);
  out.head.held_out = role == EntryRole::kHeldOut || role == EntryRole::kOther;
  out.is_other = role == EntryRole::kValidation || role == EntryRole::kOther;
  for (const ArmKey& key : armKeys())
    if (key.member == nullptr)
      out.head.payload_kg = entry.number(key.json, key.rule);
    else if (entry.has(key.json))
      out.head.*key.of_log = entry.number(key.json, key.rule);
  if (entry.has("supply_V")) out.head.supply_v = entry.number("supply_V", twin::findKey("servo", "supply")->number);
  if (entry.has("kp")) out.p_register = entry.number("kp", kRegister);
  if (entry.has("t0_session_s")) out.session_start_s = entry.number("t0_session_s", kSession);
  out.head.speed_limit_rad_s = entry.number("speed_limit_rad_s", kProfileSpeed, 0);
  if (entry.has("goal_before_rad")) out.head.goal_before_rad = entry.number("goal_before_rad", kGoal);
  out.repeats = entry.text("repeat_of", "");
  out.joint = jointOf(entry);
  out.from_s = entry.number("from_s", kClock, -std::numeric_limits<double>::infinity());
  out.to_s = entry.number("to_s", kClock, std::numeric_limits<double>::infinity());
  out.firmware_in_step = entry.flag("firmware_in_step", false);
  out.hangs_at_rad = entry.number("hangs_at_rad", {"rad", -kPi, kPi}, 0);
  if (out.from_s >= out.to_s)
    entry.fail("to_s", std::string{messages::kEndBeforeStart} + "; nothing is left of the log");
  entry.finish(warnings);
  return out;
}

}  // namespace darwinop::gap
