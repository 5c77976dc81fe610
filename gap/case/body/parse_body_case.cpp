// A case.json of the whole robot from top to bottom.
#include "gap/case/body/parse_body_case.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "core/text/formatted.hpp"
#include "core/text/nearest.hpp"
#include "gap/case/body/contradicted_recording.hpp"
#include "gap/case/body/lost_rows.hpp"
#include "gap/case/body/lying_side.hpp"
#include "gap/case/fields.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

constexpr twin::NumberRule kSession{"s", 0, 1e7};
constexpr twin::NumberRule kClock{"s", -1e9, 1e9};
constexpr twin::NumberRule kDirection{"", -1, 1};
constexpr double kUnitLength = 0.01;  // by which `up` may differ from 1: it is written with four decimals

const std::vector<std::string_view> kSetups{"stand_clamped", "floor", "lying"};

// The second is how some programs write the first.
constexpr std::string_view kGyroBias = "imu.gyro_bias_rad_s", kGyroBiasAlias = "imu.bias_rad_s";

/// Keys of `trust`, and the priors of a servo on its own that they stand for.
struct TrustKey {
  std::string_view key;
  std::vector<std::string_view> priors;
};
const std::vector<TrustKey>& trustKeys() {
  static const std::vector<TrustKey> kKeys{{"body.mass", {}},
                                           {"body.com_m", {}},
                                           {"servo", {"kt", "resistance"}},
                                           {"servo.duty_per_kp", {"duty_per_kp"}},
                                           {"servo.armature", {"armature"}},
                                           {"friction", {"coulomb.friction", "viscous.damping"}},
                                           {"floor_friction", {}},
                                           {"contact_time", {}},
                                           {kGyroBias, {}},
                                           {"imu.accel_bias_m_s2", {}},
                                           {kUpSigma, {}}};
  return kKeys;
}

void readTrust(Fields trust, BodyCase& into) {
  if (trust.flag("exact", false)) return trust.finish(into.warnings);
  if (trust.has(kGyroBiasAlias)) into.trust.emplace(kGyroBias, trust.number(kGyroBiasAlias, kRelativeSigma));
  for (const TrustKey& key : trustKeys()) {
    if (!trust.has(key.key)) continue;
    const double sigma = trust.number(key.key, kRelativeSigma);
    into.trust.insert_or_assign(std::string{key.key}, sigma);
    for (const std::string_view prior : key.priors) into.joints.priors.push_back({std::string{prior}, sigma});
  }
  trust.finish(into.warnings);
}

/// Of `up`: the side that the accelerometer shows.
constexpr std::string_view kSomeSide = "side";

void readUp(Fields& entry, BodyLog& into) {
  if (into.setup == BodySetup::kLying) {
    const std::vector<std::string_view> sides{"back", "front", "left", "right", kSomeSide};
    into.lies_on = sides[entry.word("up", sides, sides.size())];
  }
  if (into.setup != BodySetup::kClamped) return entry.leave("up");
  const std::vector<double> up = entry.numbers("up", kDirection, 3);
  const double length = std::hypot(up[0], up[1], up[2]);
  if (std::abs(length - 1) > kUnitLength)
    entry.fail("up", "has the length " + std::to_string(length) +
                         "; it has to be a unit vector, in the trunk's frame: left, up, forward");
  into.up = Axes{up[0] / length, up[1] / length, up[2] / length};
}

/// A log, and the name of the one that it repeats.
std::pair<BodyLog, std::string> readBodyEntry(Fields& entry, std::vector<std::string>& warnings) {
  BodyLog out;
  out.file = logFileIn(entry);
  const EntryRole role = roleIn(entry);
  out.held_out = role == EntryRole::kHeldOut;
  if (role != EntryRole::kFit && !out.held_out) entry.fail("role", messages::kOtherOfBody);
  out.setup = static_cast<BodySetup>(entry.word("setup", kSetups, kSetups.size()));
  readUp(entry, out);
  out.session_start_s = entry.number("session_s", kSession, 0);
  out.from_s = entry.number("from_s", kClock, -std::numeric_limits<double>::infinity());
  out.to_s = entry.number("to_s", kClock, std::numeric_limits<double>::infinity());
  if (out.from_s >= out.to_s)
    entry.fail("to_s", std::string{messages::kEndBeforeStart} + "; nothing is left of the log");
  out.battery_v = entry.number("battery_V", twin::findKey("servo", "supply")->number);
  std::string repeats = entry.text("repeat_of", "");
  entry.finish(warnings);
  return {std::move(out), std::move(repeats)};
}

std::size_t logCalled(Fields& top, const BodyCase& of, std::size_t i, const std::string& file) {
  const std::string key = "logs[" + std::to_string(i) + "].repeat_of";
  const auto found = std::ranges::find(of.logs, file, &BodyLog::file);
  if (found == of.logs.end()) top.fail(key, std::string{messages::kRepeatOfNothing} + "; it has to be the file of one");
  const auto index = static_cast<std::size_t>(found - of.logs.begin());
  if (index == i) top.fail(key, std::string{messages::kRepeatOfItself} + "; name the one before");
  return index;
}

void readLogs(Fields& top, BodyCase& into) {
  std::vector<std::string> repeats;
  for (Fields& entry : top.list("logs")) {
    auto [log, repeated] = readBodyEntry(entry, into.warnings);
    if (std::ranges::find(into.logs, log.file, &BodyLog::file) != into.logs.end())
      entry.fail("file", std::string{messages::kGivenTwice} + "; keep one of the two");
    into.logs.push_back(std::move(log));
    repeats.push_back(std::move(repeated));
  }
  if (std::ranges::all_of(into.logs, &BodyLog::held_out))
    top.fail("logs", std::string{messages::kNoFitLog} + "; there is nothing to learn from");
  for (std::size_t i = 0; i < repeats.size(); ++i)
    if (!repeats[i].empty()) into.logs[i].repeat_of = logCalled(top, into, i, repeats[i]);
}

/// A joint is absent in all logs; in some, its cable is loose.
void findAbsent(BodyCase& into) {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const auto answers = [&](std::size_t log) {
      return std::ranges::any_of(into.joint(log, joint).position_rad, [](double value) { return !std::isnan(value); });
    };
    std::vector<std::string_view> silent;
    for (std::size_t log = 0; log < into.logs.size(); ++log)
      if (!answers(log)) silent.push_back(into.logs[log].file);
    into.is_absent[joint] = silent.size() == into.logs.size();
    if (!silent.empty() && !into.is_absent[joint])
      throw BadInput(text::listed(silent) + ": " + std::string{kJointTable[joint].name} + messages::kSilentInSome);
  }
}

}  // namespace

std::string absentText(const BodyCase& given) {
  std::vector<std::string_view> absent;
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    if (given.is_absent[joint]) absent.push_back(kJointTable[joint].name);
  return absent.empty() ? "" : text::listed(absent) + messages::kNeverAnswer;
}

std::string_view name(BodySetup setup) {
  return kSetups[static_cast<std::size_t>(setup)];
}

BodyCase parseBodyCase(std::string_view json, const std::string& file, const CaseFiles& files) {
  const Json parsed = parseJson(json, file);
  Fields top{parsed, file, ""};
  BodyCase out;
  const fs::path path{file};
  out.folder = path.parent_path().empty() ? "." : path.parent_path().string();
  out.name = top.text("case", path.parent_path().filename().string());
  (void)top.word("family", {"body"}, 1);
  try {
    out.model = top.text("model");
    out.joints.model = files.model(out.model);
  } catch (const BadInput&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw BadInput(error.what());
  }
  readTrust(top.object("trust"), out);
  readLogs(top, out);
  top.finish(out.warnings);
  std::optional<logs::Log> first;
  for (BodyLog& log : out.logs) {
    logs::Log recording = loadLog(files, log.file);
    out.warnings.insert(out.warnings.end(), recording.warnings.begin(), recording.warnings.end());
    fillBodyLog(recording, log, out.joints.logs);
    if (log.fell_at_s)
      out.warnings.push_back(log.file +
                             text::formatted(": the robot falls at %.2f s; what follows is left out", *log.fell_at_s));
    if (log.lost_rows > 0)
      out.warnings.push_back(log.file + ": " + std::to_string(log.lost_rows) + messages::kRowsLost);
    if (first) refuseOtherRobot(*first, recording, out.warnings);
    recording.columns.clear();  // only the head of the first is needed again
    if (!first) first = std::move(recording);
  }
  for (std::size_t i = 0; i < out.logs.size(); ++i) {
    BodyLog& log = out.logs[i];
    if (log.lies_on != kSomeSide) continue;
    log.lies_on = sideOf(out, i);
    if (log.lies_on.empty()) throw BadInput(log.file + messages::kNoSide);
  }
  findAbsent(out);
  for (std::size_t log = 0; log < out.logs.size(); ++log) refuseContradicted(out, log);
  out.joints.name = out.name;
  out.joints.folder = out.folder;
  return out;
}

BodyCase readBodyCase(const std::string& folder) {
  return parseBodyCase(caseTextIn(folder), (fs::path{folder} / "case.json").string(), filesIn(folder));
}

bool isBodyCase(const std::string& folder) {
  return isWholeRobot(parseJson(caseTextIn(folder), (fs::path{folder} / "case.json").string()));
}

}  // namespace darwinop::gap
