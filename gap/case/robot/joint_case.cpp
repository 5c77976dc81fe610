#include "gap/case/robot/joint_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "experiments/logs/date.hpp"
#include "experiments/logs/read_log.hpp"
#include "gap/case/baseline_keys.hpp"
#include "gap/case/folder_files.hpp"
#include "gap/case/parse_case.hpp"
#include "gap/case/robot/alone.hpp"
#include "gap/case/write_case.hpp"
#include "twin/bench/bench.hpp"
#include "twin/body/imu_axes.hpp"
#include "twin/body/pendulum.hpp"
#include "twin/model/copy_body.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array kUpright{0.0, 0.0, 9.81};  // what an accelerometer would read

bool isTilted(const AlonePart& part) {
  return std::ranges::all_of(part.accel_m_s2, [](double axis) { return std::isfinite(axis); });
}

/// One log of the case.
struct Part {
  std::string source, file, kind;
  bool held_out;
  AlonePart what;
  double zero_s;  // the session's clock where that of the recording, which is the computer's, is 0
  twin::JointPendulum pendulum;
};

std::string sentence(const Part& part, const std::string& log) {
  char text[400];
  std::snprintf(text, sizeof text, "%s: %s, %.1f to %.1f s, %s; weight %.4f N m, inertia %.5f kg m2, hangs at %.3f rad",
                log.c_str(), part.file.c_str(), part.what.from_s, part.what.to_s,
                part.held_out ? "held out" : "to be fitted", part.pendulum.weight_nm, part.pendulum.inertia_kgm2,
                part.pendulum.hangs_at_rad);
  std::string said = text;
  if (!isTilted(part.what)) said += messages::kTakenAsUpright;
  if (!(part.what.supply_v > 0)) said += messages::kSupplyOfModel;
  return said;
}

twin::JointPendulum pendulumOf(const twin::Model& model, Joint joint, const AlonePart& part, const std::string& file) {
  try {
    return twin::pendulumOf(model, joint, part.angles_rad, isTilted(part) ? part.accel_m_s2 : kUpright);
  } catch (const std::runtime_error& unknown) {
    throw std::runtime_error(file + ": " + unknown.what());
  }
}

/// When each recording began in the session, s: by their dates, if all have one, else one right after the other. Two
/// never overlap; a date is to 1 s, and the twin is faster than its clock.
std::vector<double> beginsOf(const std::vector<logs::Log>& recordings) {
  std::vector<std::size_t> order(recordings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto date = [&](std::size_t i) { return logs::dateOf(recordings[i]); };
  const bool dated = std::ranges::all_of(order, [&](std::size_t i) { return date(i).has_value(); });
  if (dated) std::ranges::stable_sort(order, {}, [&](std::size_t i) { return *date(i); });
  std::vector<double> begins(recordings.size());
  double end_s = 0;
  for (const std::size_t i : order) {
    begins[i] = dated ? std::max(end_s, *date(i) - *date(order.front())) : end_s;
    end_s = begins[i] + recordings[i].seconds(recordings[i].rows() - 1) - recordings[i].seconds(0);
  }
  return begins;
}

std::vector<Part> partsOf(const JointCaseRequest& request, const twin::Model& model,
                          std::vector<std::string>& warnings) {
  std::vector<Part> parts;
  std::vector<logs::Log> recordings;
  for (const std::vector<std::string>* const files : {&request.recordings, &request.held_out})
    for (const std::string& file : *files) recordings.push_back(logs::readLog(file));
  for (const logs::Log& log : recordings) warnings.insert(warnings.end(), log.warnings.begin(), log.warnings.end());
  const std::vector<double> begins_s = beginsOf(recordings);
  const auto add = [&](std::size_t i, bool held_out) {
    const logs::Log& log = recordings[i];
    const std::string& file = log.file;
    std::vector<AlonePart> found = aloneParts(log, request.joint);
    if (found.empty())
      throw std::runtime_error(file + ": there are no 2 s in which " +
                               std::string{kJointTable[static_cast<std::size_t>(request.joint)].name} +
                               " moves and all other joints hold their goals; was it another joint's?");
    const fs::path path{file};
    for (AlonePart& one : found) {
      one.accel_m_s2 = twin::idealReading(model, one.accel_m_s2);
      parts.push_back({file, path.filename().string(), log.headValue("experiment").value_or(path.stem().string()),
                       held_out, one, begins_s[i] - log.seconds(0), pendulumOf(model, request.joint, one, file)});
    }
  };
  for (std::size_t i = 0; i < recordings.size(); ++i) add(i, i >= request.recordings.size());
  if (request.recordings.empty()) throw std::runtime_error("a case needs a recording to be fitted; name one or more");
  return parts;
}

/// Weight and inertia as one weight at the end of an arm without mass. Tilt and pose change both, each in its own way.
double lengthOf(const Part& part) {
  constexpr double kUnloaded = 1e-6;  // N m
  if (!(part.pendulum.weight_nm > kUnloaded))
    throw std::runtime_error(part.file +
                             ": the joint turns about an upright axis and carries no weight; take one that does");
  return part.pendulum.inertia_kgm2 * twin::Pendulum{}.gravity_m_s2 / part.pendulum.weight_nm;
}

Json priorsOf(const twin::Model& model, Joint joint) {
  // Uncertainty of data sheet and drawings.
  Json priors = {{"kt", 0.02}, {"resistance", 0.04}, {"armature", 0.1}, {"payload", 0.02}, {"length", 0.02}};
  for (const twin::EffectSetting& effect : model.effects) {
    if (effect.joint && effect.joint != joint) continue;
    for (const FrictionKey& key : frictionKeys())
      if (key.effect == effect.info) priors[key.prior] = 0.1;
  }
  return priors;
}

/// File of a part in the case: unique, as recordings of two folders may have one name.
std::string nameOf(const Part& part, std::size_t number) {
  return fs::path{part.file}.stem().string() + "_" + std::to_string(number + 1) + ".csv";
}

Json logOf(const Part& part, std::size_t number, Joint joint) {
  const double length_m = lengthOf(part);
  const double payload = part.pendulum.weight_nm / twin::Pendulum{}.gravity_m_s2 / length_m;
  Json log = {{"file", nameOf(part, number)},
              {"role", part.held_out ? "held_out" : "fit"},
              {"trajectory", part.kind},
              {"joint", kJointTable[static_cast<std::size_t>(joint)].name},
              {"from_s", part.what.from_s},
              {"to_s", part.what.to_s},
              {"hangs_at_rad", part.pendulum.hangs_at_rad},
              {"payload_kg", payload},
              {"length_m", length_m},
              {"t0_session_s", part.zero_s + part.what.from_s}};
  if (!std::isnan(part.what.goal_before_rad)) log["goal_before_rad"] = part.what.goal_before_rad;
  if (part.what.supply_v > 0) log["supply_V"] = part.what.supply_v;  // a battery's falls in a session
  return log;
}

}  // namespace

JointCaseNotes writeJointCase(const JointCaseRequest& request, const std::string& folder) {
  twin::Model model = twin::readModel(twin::findModel(request.model));
  JointCaseNotes notes;
  const std::vector<Part> parts = partsOf(request, model, notes.warnings);
  if (const double supply = parts.front().what.supply_v; supply > 0) model.servo.supply_v = supply;

  Json json = {{"case", nameOfFolder(folder)},
               {"model", "model.ini"},
               {"arm", {{"arm_mass_kg", 0.0}, {"length_m", lengthOf(parts.front())}}},
               {"prior_rel_sigma", priorsOf(model, request.joint)},
               {"logs", Json::array()}};
  for (std::size_t i = 0; i < parts.size(); ++i) json["logs"].push_back(logOf(parts[i], i, request.joint));
  const CaseFiles files{.log =
                            [&](const std::string& name) {
                              std::size_t i = 0;
                              while (nameOf(parts[i], i) != name) ++i;
                              return logs::readLog(parts[i].source);
                            },
                        .model = [&](const std::string&) { return model; }};
  Case made = parseCase(json.dump(), (fs::path{folder} / "case.json").string(), files);

  for (std::size_t i = 0; i < parts.size(); ++i) {
    // A load is that of the last period of the firmware before the read. Where that period is unknown, a goal may show
    // in it a period too early or too late, like an effect.
    if (!made.logs[i].isReadAfterWrite())
      std::ranges::fill(made.logs[i].load, std::numeric_limits<double>::quiet_NaN());
    notes.logs.push_back(sentence(parts[i], made.logs[i].file));
  }
  if (const std::string wrong = twin::copyBody(model, folder, twin::OtherBody::kReplace); !wrong.empty())
    throw std::runtime_error(wrong);
  writeCase(made, folder);
  return notes;
}

}  // namespace darwinop::gap
