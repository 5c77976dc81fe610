#include "gap/localize/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/conversions.hpp"
#include "gap/fit/unknown.hpp"
#include "gap/localize/command_split.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

std::string percent(double share) {
  return std::to_string(std::lround(100 * share)) + " %";
}

std::string oneDigit(double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.1f", value))};
}

class Finder {
 public:
  Finder(const Plant& plant, const Case& given, const Hypothesis& baseline, const std::vector<std::size_t>& logs,
         const SimulatedRepeats& copies)
      : plant_{plant},
        given_{given},
        logs_{logs},
        copies_{copies},
        baseline_{baseline},
        numbers_{nuisancesOf(given, baseline)} {
    for (std::size_t i = 0; i < kBlocks; ++i) {
      out_.all[i].block = static_cast<Block>(i);
      out_.all[i].rms = out_.all[i].expected_rms = kNotKnown;
    }
  }

  Blocks find() {
    supply();
    sensor();
    if (baseline_.servo.law == twin::Law::kSpeedP)
      lawAndMotorAtOnce();
    else if (std::ranges::any_of(logs_, [&](std::size_t i) { return loadIsDutyIn(baseline_, given_.logs[i]); }))
      lawByItsDuty();
    else
      noDuty();
    for (const Block block : plant_.blocks())
      if (!out_.first && out_.of(block).verdict == BlockVerdict::kOpen) out_.first = block;
    return std::move(out_);
  }

 private:
  /// At the place of the case's joint.
  [[nodiscard]] BlockResiduals residuals(Block block, const Trajectory& log, const Hypothesis& hypothesis,
                                         const ShootingOptions& options = {}) const {
    return plant_.blockResiduals(block, plant_.places().front(), given_, log, hypothesis, options);
  }
  [[nodiscard]] BlockTest judged(const BlockResidualFunction& cut, bool priors = true) const {
    return judge(cut, given_, logs_, copies_, baseline_, priors ? numbers_ : std::vector<Unknown>{});
  }
  [[nodiscard]] BlockTest judgedWith(const BlockResidualFunction& cut, const Hypothesis& hypothesis) const {
    return judge(cut, given_, logs_, simulateRepeats(plant_, given_, logs_, hypothesis), hypothesis,
                 nuisancesOf(given_, hypothesis));
  }

  void take(Block block, BlockTest judgement, const std::string& unit, double per_unit) {
    BlockFinding& into = out_.of(block);
    into.unit = unit;
    into.rms = judgement.rms / per_unit;
    into.expected_rms = judgement.expected_rms / per_unit;
    into.significance = judgement.significance;
    into.moved = judgement.moved;
    into.verdict = judgement.isOpen() ? BlockVerdict::kOpen : BlockVerdict::kClosed;
    if (judgement.significance <= thresholds::kOpenSigmas && judgement.moved > thresholds::kMovedSigmas)
      into.detail = "closes only with numbers far outside their priors, " + oneDigit(judgement.moved) + " sigma";
    into.samples = std::move(judgement.samples);
  }

  void notCut(Block block, const std::string& why) { out_.of(block).detail = why; }

  void supply() {
    out_.supply_ohm = out_.supply_ohm_sigma = kNotKnown;
    const BlockTest cut = judged([&](const auto& log, const auto& h) { return residuals(Block::kSupply, log, h); });
    if (!cut.known()) return notCut(Block::kSupply, "the logs have no voltage");
    BlockFinding& into = out_.of(Block::kSupply);
    take(Block::kSupply, cut, "V", 1);
    if (baseline_.servo.law == twin::Law::kSpeedP) return;  // the current of its motor is unknown
    std::vector<const Trajectory*> measured;
    measured.reserve(logs_.size());
    for (const std::size_t i : logs_) measured.push_back(&given_.logs[i]);
    const double slope = plant_.supplyResistance(plant_.places().front(), given_, measured, baseline_);
    double spread = 0;
    for (const auto& run : copies_) {
      std::vector<const Trajectory*> copied;
      copied.reserve(run.size());
      for (const Trajectory& log : run) copied.push_back(&log);
      spread += std::pow(plant_.supplyResistance(plant_.places().front(), given_, copied, baseline_), 2) /
                static_cast<double>(copies_.size());
    }
    out_.supply_ohm = slope;
    out_.supply_ohm_sigma = std::sqrt(spread);
    if (std::isnan(slope)) return;
    char text[80];
    std::snprintf(text, sizeof text, "%.2f +- %.2f ohm", slope, out_.supply_ohm_sigma);
    into.detail = text;
    into.significance = std::max(into.significance, std::abs(slope) / out_.supply_ohm_sigma);
    if (into.significance > thresholds::kOpenSigmas) into.verdict = BlockVerdict::kOpen;
  }

  void sensor() {
    BlockTest cut = judged([&](const auto& log, const auto& h) { return residuals(Block::kSensor, log, h); }, false);
    if (!cut.known()) return notCut(Block::kSensor, "the logs have no speed");
    take(Block::kSensor, std::move(cut), "rad/s", 1);
    BlockFinding& into = out_.of(Block::kSensor);
    if (into.rms < thresholds::kSensorRatio * into.expected_rms) into.verdict = BlockVerdict::kClosed;
  }

  void lawByItsDuty() {
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

  /// `without`: before findings in other blocks were applied. A small remainder is the error of that finding.
  void takePlant(const BlockTest& without, BlockTest with, const std::string& how) {
    const double before = without.cost - without.expected_cost, after = with.cost - with.expected_cost;
    take(Block::kPlant, std::move(with), "mrad", 1e-3);
    BlockFinding& plant = out_.of(Block::kPlant);
    plant.detail = how;
    if (plant.verdict != BlockVerdict::kOpen || after > thresholds::kPlantRemainderShare * before) return;
    plant.verdict = BlockVerdict::kClosed;
    plant.detail += ", which leaves " + percent(after / before);
  }

  /// Law speed_p has no duty: the motor takes the commanded speed at once.
  void lawAndMotorAtOnce() {
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

  void noDuty() {
    notCut(Block::kCommand, "no load column: not distinguishable from the plant");
    notCut(Block::kController, "no load column: not distinguishable from the plant");
    take(Block::kPlant, judged([&](const auto& log, const auto& h) { return residuals(Block::kPlant, log, h); }),
         "mrad", 1e-3);
    out_.of(Block::kPlant).detail = "with command and controller: there is no load column";
  }

  /// No signal is measured between command and controller; the finding is assigned to one of the two.
  void share(const CommandSplit& split, bool open) {
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
                                  percent(split.by_controller.share) + "; " + percent(split.at_rest) +
                                  " with the goal at rest";
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

  [[nodiscard]] double dutyPerTick() const {
    double gain = 0;
    for (const std::size_t i : logs_) gain += given_.logs[i].p_register / static_cast<double>(logs_.size());
    return gain * baseline_.servo.duty_per_kp_per_rad * 2 * kPi / baseline_.servo.ticks_per_rev;
  }

  const Plant& plant_;
  const Case& given_;
  const std::vector<std::size_t>& logs_;
  const SimulatedRepeats& copies_;
  const Hypothesis& baseline_;
  std::vector<Unknown> numbers_;
  Blocks out_;
};

}  // namespace

std::string_view name(BlockVerdict verdict) {
  switch (verdict) {
    case BlockVerdict::kClosed:
      return "closed";
    case BlockVerdict::kOpen:
      return "open";
    case BlockVerdict::kNotTestable:
      break;
  }
  return "not cut";
}

Blocks findBlocks(const Plant& plant, const Case& given, const Hypothesis& baseline,
                  const std::vector<std::size_t>& logs, const SimulatedRepeats& copies) {
  return Finder{plant, given, baseline, logs, copies}.find();
}

}  // namespace darwinop::gap
