// A folder of BAM logs as a case.
#include <algorithm>
#include <filesystem>
#include <set>

#include "gap/case/bam_log.hpp"
#include "gap/case/messages.hpp"
#include "hal/text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestBamLog = std::size_t{1} << 28;  // bytes

/// How well a sheet and a scale know a bench: the maker's torque to a tenth, winding and gear worse.
const std::vector<Prior> kBenchPriors{
    {"kt", 0.1}, {"resistance", 0.15}, {"armature", 0.5}, {"payload", 0.02}, {"length", 0.02}};

std::vector<fs::path> jsonFiles(const std::string& folder) {
  std::error_code failed;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder, failed})
    if (entry.path().extension() == ".json" && entry.is_regular_file()) found.push_back(entry.path());
  if (failed) throw BadInput("cannot read " + folder + ": " + failed.message());
  if (found.empty()) throw BadInput(folder + ": " + messages::kNoBamLogs);
  std::ranges::sort(found);
  return found;
}

std::string stemOf(const std::string& file) {
  return fs::path{file}.stem().string();
}

void holdOut(const std::vector<std::string>& names, BamCase& in) {
  std::vector<Trajectory>& logs = in.given.logs;
  for (const std::string& name : names)
    if (std::ranges::none_of(logs, [&](const Trajectory& log) { return stemOf(log.file) == stemOf(name); }))
      throw BadInput("--keep " + name + messages::kNotLogOfFolder + in.given.folder);
  double greatest = 0, least = 1e9;
  for (const Trajectory& log : logs)
    greatest = std::max(greatest, log.p_register), least = std::min(least, log.p_register);
  const std::size_t quarter = logs.size() < 2 ? 0 : (logs.size() + 3) / 4;  // a lone log is fitted
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const std::string stem = stemOf(logs[i].file);
    const bool named = std::ranges::any_of(names, [&](const std::string& name) { return stemOf(name) == stem; });
    logs[i].held_out = !names.empty()     ? named
                       : greatest > least ? logs[i].p_register == greatest
                                          : i + quarter >= logs.size();
  }
  const auto held = std::ranges::count_if(logs, &Trajectory::held_out);
  if (names.empty())
    in.notes.push_back(std::to_string(held) + " of " + std::to_string(logs.size()) +
                       " logs are held out: " + (greatest > least ? "those of the greatest kp" : "the last quarter") +
                       "; choose others with --keep");
}

}  // namespace

BamCase readBamFolder(const std::string& folder, const std::string& model, const std::vector<std::string>& held_out) {
  BamCase out;
  Case& c = out.given;
  try {
    c.model = twin::readModel(fs::exists(model) ? model : twin::findModel(model));
  } catch (const std::runtime_error& error) {
    throw BadInput(error.what());
  }
  std::erase_if(c.model.effects, [](const twin::EffectSetting& effect) { return effect.joint.has_value(); });
  c.folder = folder;
  c.name = fs::path{folder + "/."}.parent_path().filename().string();
  c.model.name = c.name;
  c.goal_order = GoalOrder::kBeforeRead;
  c.priors = kBenchPriors;
  std::set<std::string> motors;
  for (const fs::path& path : jsonFiles(folder)) {
    std::optional<std::string> text;
    try {
      text = readTextFile(path.string(), kLongestBamLog);
    } catch (const std::runtime_error& error) {
      throw BadInput(error.what());
    }
    BamLog log = parseBamLog(text.value_or(""), path.string(), path.stem().string());
    motors.insert(log.motor);
    out.notes.insert(out.notes.end(), log.notes.begin(), log.notes.end());
    c.logs.push_back(std::move(log.log));
  }
  if (motors.size() > 1) throw BadInput(folder + ": " + messages::kSeveralMotors);
  c.pendulum.length_m = *c.logs.front().length_m;
  c.pendulum.arm_mass_kg = *c.logs.front().arm_mass_kg;
  if (c.logs.front().supply_v) c.model.servo.supply_v = *c.logs.front().supply_v;
  holdOut(held_out, out);
  out.notes.push_back("goals count as written before the read of their row, as BAM's recorder does");
  out.notes.push_back("motor \"" + *motors.begin() + "\" has the numbers of model " + model +
                      "; correct them in the case");
  return out;
}

}  // namespace darwinop::gap
