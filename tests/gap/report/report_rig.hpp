// A report that is made by hand: nothing is fitted and little is simulated.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "gap/report/messages.hpp"
#include "gap/report/report.hpp"
#include "gap/report/sentences.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {

inline constexpr double kMrad = 1e-3;

/// Two short logs; the fitted one's name is as hostile as a file's can be.
inline Case twoLogs() {
  Case bench = smallBench();
  bench.name = "e<1>";
  bench.model.servo.kt_nm_a = 1.786;
  bench.logs = {bench.logs.front(), bench.logs.back()};
  bench.logs[0].file = "fit</script><!--&\"1\".csv";
  bench.logs[1].file = "score_1.csv";
  for (Trajectory& log : bench.logs) {
    log.time_s.resize(60), log.goal_rad.resize(60), log.torque_on.resize(60), log.lines.resize(60);
    log.position_rad = log.goal_rad;
    for (auto* column : {&log.speed_rad_s, &log.load, &log.volt_v, &log.temp_c})
      column->assign(60, std::numeric_limits<double>::quiet_NaN());
  }
  return bench;
}

inline Gap gapOfMrad(double before, double after, double floor) {
  Gap gap;
  gap.before_rad = before * kMrad, gap.after_rad = after * kMrad, gap.floor_rad = floor * kMrad;
  return gap;
}

inline Comparison errorScaleOf(const Case& given) {
  Comparison comparison;
  for (std::size_t i = 0; i < given.logs.size(); ++i) {
    const std::vector<double> still(given.logs[i].rows(), 0.1 * static_cast<double>(i));
    comparison.logs.push_back(
        {.log = i,
         .gap = given.logs[i].held_out ? gapOfMrad(31.0412, 0.9314, 0.8881) : gapOfMrad(24.5, 0.87, 0.9),
         .noise_share = 1,
         .below_floor = false,
         .before_rad = still,
         .after_rad = still});
    (given.logs[i].held_out ? comparison.held_out : comparison.fit) = comparison.logs.back().gap;
    ++(given.logs[i].held_out ? comparison.held_out_logs : comparison.fit_logs);
  }
  return comparison;
}

/// "named": dry friction of 0.0423 N m, and a motor constant that moved inside its prior.
inline Outcome dryFriction(const Case& given) {
  Outcome outcome;
  outcome.baseline = baselineOf(given);
  Identification& identification = outcome.identification;
  identification.verdict = Verdict::kNamed;
  identification.model = baselineOf(given);
  identification.model.servo.kt_nm_a *= 1.0123;
  identification.model.find("viscous")->values[0] = 0.0161;
  identification.model.with(*twin::findEffect("coulomb")).values = {0.0423};
  identification.model.payload_scale = 1.0042;
  identification.effects = {
      {twin::findEffect("coulomb"), {{"coulomb.friction", "N m", 0.0423, 0.0401, 0.0447}}, 312.4}};
  identification.rivals = {{{"deadband"}, 45.3}, {{"viscous", "backlash"}, 77.7}};
  identification.prior_conflicts = {{"length", 3.4, 1.034}};
  identification.threshold = 27.6;
  identification.misfit = 0.7;
  identification.gap_before_rad = 24.5 * kMrad, identification.gap_after_rad = 0.87 * kMrad,
  identification.floor_rad = 0.9 * kMrad;
  outcome.verification.rms_before_rad = 31.0412 * kMrad, outcome.verification.rms_after_rad = 0.9314 * kMrad;
  outcome.runtime_s = 12.3;
  outcome.localization.places = {
      {"position", "", given.logs.front().file, 0.3, 0.6, "step", Block::kPlant, 900.5, 20, 45.6, "mrad"}};
  outcome.localization.blocks.first = Block::kPlant;
  return outcome;
}

/// Report and what it is of.
struct ReportRig {
  Case given = twoLogs();
  Outcome outcome = dryFriction(given);
  Report report;

  ReportRig() { make(); }
  ReportRig(const ReportRig&) = delete;
  ReportRig& operator=(const ReportRig&) = delete;
  void make() {
    report.given = &given;
    report.outcome = &outcome;
    report.comparison = errorScaleOf(given);
    report.model_before = caseModel(given);
    report.data_hash = std::string(64, 'a');
    report.model_after = withAdditions(report.model_before, additionsOf(given, outcome, report.data_hash));
    report.commands = {"darwinop gap run 'cases/e<1>'"};
  }
};

}  // namespace darwinop::gap
