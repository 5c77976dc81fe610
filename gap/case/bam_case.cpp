// A folder of BAM logs as a case.
#include <filesystem>

#include "gap/case/bam_log.hpp"
#include "gap/case/folder_files.hpp"
#include "gap/case/messages.hpp"
#include "hal/text_file.hpp"

namespace darwinop::gap {

namespace fs = std::filesystem;

FolderCase readBamFolder(const std::string& folder, const std::string& model, const Declarations& declared) {
  FolderCase out;
  Case& c = out.given;
  try {
    c.model = twin::readModel(fs::exists(model) ? model : twin::findModel(model));
  } catch (const std::runtime_error& error) {
    throw BadInput(error.what());
  }
  std::erase_if(c.model.effects, [](const twin::EffectSetting& effect) { return effect.joint.has_value(); });
  c.folder = folder;
  c.name = nameOfFolder(folder);
  c.model.name = c.name;
  c.goal_order = GoalOrder::kBeforeRead;
  c.priors = benchPriors();
  std::vector<BamLog> logs;
  const std::vector<fs::path> files = filesEndingWith(folder, ".json");
  if (files.empty()) throw BadInput(folder + ": " + messages::kNoBamLogs);
  for (const fs::path& path : files) {
    try {
      const std::optional<std::string> text = readTextFile(path.string(), kLongestBamLog);
      logs.push_back(parseBamLog(text.value_or(""), path.string(), path.stem().string()));
    } catch (const std::runtime_error& error) {
      out.unusable.emplace_back(error.what());
    }
  }
  if (logs.empty()) refuseUnusable(out);
  out.motor = keepOneMotor(declared.text("motor"), folder, logs, out.notes);
  convertLoads(logs);
  for (BamLog& log : logs) {
    out.notes.insert(out.notes.end(), log.notes.begin(), log.notes.end());
    c.logs.push_back(std::move(log.log));
  }
  c.pendulum.length_m = *c.logs.front().length_m;
  c.pendulum.arm_mass_kg = *c.logs.front().arm_mass_kg;
  if (c.logs.front().supply_v) c.model.servo.supply_v = *c.logs.front().supply_v;  // else takeSupply()
  return out;
}

}  // namespace darwinop::gap
