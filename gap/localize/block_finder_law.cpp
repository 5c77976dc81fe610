// Controller, command and plant, by the signals that the logs have.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/conversions.hpp"
#include "gap/localize/block_finder.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

std::string percent(double share) {
  return std::to_string(std::lround(100 * share)) + " %";
}

}  // namespace

void BlockFinder::lawByItsDuty() {
  const BlockResidualFunction law = [&](const auto& log, const auto& h) {
    return residuals(Block::kController, log, h);
  };
  BlockTest duty = judged(law);
  bool law_open = duty.isOpen();
  CommandSplit split;
  if (law_open) split = splitCommand(law, given_, logs_, duty, baseline_);
  // Rounding differs with the motion: an excess as small as noise that no change explains does not count.
  if (std::max(split.by_command.share, split.by_controller.share) < thresholds::kControllerExplainedShare &&
      duty.rms < thresholds::kControllerNoiseRatio * duty.expected_rms)
    law_open = false;
  take(Block::kController, std::move(duty), "ticks", dutyPerTick());
  if (!law_open) out_.of(Block::kController).verdict = BlockVerdict::kClosed;
  share(split, law_open);

  const auto plant = [&](bool measured_supply) -> BlockResidualFunction {
    return [this, measured_supply](const auto& log, const auto& h) {
      return residuals(Block::kPlant, log, h, {.measured_supply = measured_supply});
    };
  };
  BlockTest windows = judged(plant(false));
  const bool supply_open = out_.of(Block::kSupply).verdict == BlockVerdict::kOpen;
  if (law_open || supply_open) {
    // Findings in earlier blocks are applied first: between the rows only the law gives the duty.
    const Hypothesis& law_found = law_open ? split.best().hypothesis : baseline_;
    BlockTest with = judgedWith(plant(supply_open), law_found);
    // At the reads a delay shows in whole rows only; the plant resolves fractions.
    if (law_open && with.isOpen() && split.isCommand() && law_found.value(twin::ParameterRole::kGoalDelay)) {
      const Explained delay = explainByDelay(plant(supply_open), given_, logs_, windows, baseline_);
      with = judgedWith(plant(supply_open), delay.hypothesis);
    }
    takePlant(windows, std::move(with), "with what was found before it");
    return;
  }
  if (windows.isOpen()) {
    const Explained delay = explainByDelay(plant(false), given_, logs_, windows, baseline_);
    if (delay.share > thresholds::kDelayShare) {
      take(Block::kCommand, windows, "mrad", 1e-3);
      out_.of(Block::kCommand).detail =
          "a delay below a row's time takes away " + percent(delay.share) + " of what the plant shows";
      takePlant(windows, judgedWith(plant(false), delay.hypothesis), "with that delay");
      return;
    }
  }
  take(Block::kPlant, std::move(windows), "mrad", 1e-3);
}

void BlockFinder::takePlant(const BlockTest& without, BlockTest with, const std::string& how) {
  const double before = without.cost - without.expected_cost, after = with.cost - with.expected_cost;
  take(Block::kPlant, std::move(with), "mrad", 1e-3);
  BlockFinding& plant = out_.of(Block::kPlant);
  plant.detail = how;
  if (plant.verdict != BlockVerdict::kOpen || after > thresholds::kPlantRemainderShare * before) return;
  plant.verdict = BlockVerdict::kClosed;
  plant.detail += ", which leaves " + percent(after / before);
}

void BlockFinder::lawAndMotorAtOnce() {
  const BlockResidualFunction law = [&](const auto& log, const auto& h) {
    return residuals(Block::kPlant, log, h,
                     {.length_s = thresholds::kSpeedLawWindow, .powered = true, .limp = false, .mixed = false});
  };
  BlockTest rows = judged(law);
  const bool open = rows.isOpen();
  CommandSplit split;
  if (open) split = splitCommand(law, given_, logs_, rows, baseline_);
  if (rows.known()) take(Block::kController, std::move(rows), "mrad", 1e-3);
  share(split, open);
  BlockTest limp = judged([&](const auto& log, const auto& h) {
    return residuals(Block::kPlant, log, h, {.powered = false, .limp = true, .mixed = false});
  });
  if (!limp.known()) return notCut(Block::kPlant, kPlantNeedsTorqueOff);
  take(Block::kPlant, std::move(limp), "mrad", 1e-3);
  out_.of(Block::kPlant).detail = "law speed_p: seen with torque off only";
}

void BlockFinder::noDuty() {
  notCut(Block::kCommand, "no load column: not distinguishable from the plant");
  notCut(Block::kController, "no load column: not distinguishable from the plant");
  take(Block::kPlant, judged([&](const auto& log, const auto& h) { return residuals(Block::kPlant, log, h); }), "mrad",
       1e-3);
  out_.of(Block::kPlant).detail = "with command and controller: there is no load column";
}

void BlockFinder::share(const CommandSplit& split, bool open) {
  BlockFinding& command = out_.of(Block::kCommand);
  BlockFinding& controller = out_.of(Block::kController);
  if (!open) {
    command = controller;
    command.block = Block::kCommand;
    command.samples.clear();
    command.detail = "cut together with the controller";
    return;
  }
  const std::string formatted = "a slower or later goal explains " + percent(split.by_command.share) + ", the law " +
                                percent(split.by_controller.share) + "; with the goal at rest a sample has " +
                                percent(split.at_rest) + " of the mean";
  controller.detail = formatted;
  if (!split.isCommand()) {
    command.detail = "not to be cut from the controller, which explains more";
    return;
  }
  command = controller;
  command.block = Block::kCommand;
  controller.verdict = BlockVerdict::kNotTestable;
  controller.samples.clear();
  controller.detail = "not to be cut from the command, which explains more";
}

double BlockFinder::dutyPerTick() const {
  double gain = 0;
  for (const std::size_t i : logs_) gain += given_.logs[i].p_register / static_cast<double>(logs_.size());
  return gain * baseline_.servo.duty_per_kp_per_rad * 2 * kPi / baseline_.servo.ticks_per_rev;
}

}  // namespace darwinop::gap
