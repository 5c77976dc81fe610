#include "gap/plan/experiment_candidate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/conversions.hpp"
#include "experiments/format/experiment_files.hpp"
#include "experiments/format/reader.hpp"
#include "gap/case/median.hpp"
#include "gap/plan/bench_experiments.hpp"

namespace darwinop::gap {
namespace {

using experiments::Experiment;
using experiments::Phase;

constexpr double kChange = 60;         // s, that a person takes to change the weight
constexpr double kHeavier = 0.1;       // kg, and at least
constexpr double kHeavierShare = 0.3;  // of what is lifted: the data check counts from 10 % as another payload
constexpr double kWeight = 0.05;       // kg: what a person has at hand

std::string inGrams(double kg) {
  return std::to_string(std::lround(kg * 1000)) + " g";
}

ExperimentCandidate plainly(Experiment experiment, const Circumstances& at) {
  ExperimentCandidate candidate;
  candidate.experiment = std::move(experiment);
  candidate.payload_kg = at.payload_kg;
  candidate.temp_c = at.cold_c;
  return candidate;
}

ExperimentCandidate withPayload(ExperimentCandidate candidate, const std::string& suffix, double payload_kg) {
  const double more = payload_kg - candidate.payload_kg;
  candidate.experiment.name += suffix;
  candidate.prepare =
      more > 0 ? "hang " + inGrams(more) + " more to the arm" : "take " + inGrams(-more) + " off the arm";
  candidate.experiment.title += more > 0 ? ", with +" + inGrams(more) : ", with -" + inGrams(-more);
  candidate.prepare_s = kChange;
  candidate.payload_kg = payload_kg;
  return candidate;
}

/// Those that the catalogue recommends at other payloads.
bool wantsPayloads(const std::string& name) {
  for (const std::string_view known :
       {"steps", "slow_triangle", "chirp", "release", "hold_from_both_sides", "constant_speed", "long_steps"})
    if (name == known) return true;
  return false;
}

double moreThan(double payload_kg) {
  return std::max(kHeavier, std::round(kHeavierShare * payload_kg / kWeight) * kWeight);
}

void addPayloads(const Circumstances& at, std::vector<ExperimentCandidate>& all) {
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!wantsPayloads(all[i].experiment.name)) continue;
    all.push_back(withPayload(all[i], "_heavier", at.payload_kg + moreThan(at.payload_kg)));
    if (at.payload_kg > kHeavier) all.push_back(withPayload(all[i], "_lighter", at.payload_kg / 2));
  }
}

/// The first log at the end of the session: what changed meanwhile did so with the clock.
void addFirstLogAgain(const Case& given, const ArmSetup& stand, const Circumstances& at,
                      std::vector<ExperimentCandidate>& all) {
  const auto first = std::ranges::find(given.logs, false, &Trajectory::held_out);
  if (first == given.logs.end()) return;
  ExperimentCandidate last = plainly(again(*first, stand, "first_log_again"), at);
  last.payload_kg = first->payload_kg;
  last.prepare = "run it last, after some minutes of the others, when the servo is warm";
  last.temp_c = at.warm_c;
  last.session_start_s = at.session_end_s;
  all.push_back(std::move(last));
}

}  // namespace

Circumstances circumstancesOf(const Case& given) {
  Circumstances at;
  std::map<double, int> payloads;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Trajectory& log : given.logs) {
    ++payloads[log.payload_kg];
    at.session_end_s = std::max(at.session_end_s, log.session_start_s + log.duration_s());
    for (const double temp : log.temp_c)
      if (!std::isnan(temp)) low = std::min(low, temp), high = std::max(high, temp);
  }
  std::vector<double> gains;
  for (const Trajectory& log : given.logs)
    if (!log.held_out) gains.push_back(log.p_register / kRegisterPerKp);
  if (const double middle = medianOf(std::move(gains)); !std::isnan(middle)) at.p_gain = middle;
  int most = 0;
  for (const auto& [payload, count] : payloads)
    if (count > most) most = count, at.payload_kg = payload;
  if (low <= high) at.cold_c = low, at.warm_c = high;
  return at;
}

std::optional<Experiment> movedTo(const ArmSetup& stand, Experiment experiment) {
  std::optional<Joint> from;
  if (experiment.setup.named->on_feet) return std::nullopt;
  for (const experiments::Round& round : experiment.rounds)
    for (const Phase& phase : round.phases) {
      if (phase.joints.size() != 1 || phase.joints[0].sign < 0) return std::nullopt;
      if (from && *from != phase.joints[0].joint) return std::nullopt;
      from = phase.joints[0].joint;
    }
  if (*from == stand.joint && stand.hangs_at_rad == armSetupFor(stand.joint).hangs_at_rad) return experiment;
  const double by = stand.hangs_at_rad - armSetupFor(*from).hangs_at_rad;
  const double begin = experiment.setup.pose[index(*from)] + by;
  experiment.setup = stand.setup;
  experiment.setup.pose[index(stand.joint)] = begin;
  takeTimeFor(experiment.setup);
  experiment.record_joints = {stand.joint};
  for (experiments::Round& round : experiment.rounds)
    for (Phase& phase : round.phases) {
      phase.joints = {{stand.joint, 1}};
      phase.goal.to += by;
      if (phase.arrive_at) *phase.arrive_at += by;
      for (double& goal : phase.goal.goals) goal += by;
    }
  return experiment;
}

std::vector<ExperimentCandidate> benchCandidates(const Case& given, const ArmSetup& stand) {
  const Circumstances at = circumstancesOf(given);
  std::vector<ExperimentCandidate> all;
  for (Experiment& experiment : benchExperiments(stand, at.p_gain)) all.push_back(plainly(std::move(experiment), at));
  addPayloads(at, all);
  addFirstLogAgain(given, stand, at, all);
  return all;
}

std::vector<ExperimentCandidate> candidatesFor(const Case& given, const ArmSetup& stand) {
  const Circumstances at = circumstancesOf(given);
  std::vector<ExperimentCandidate> all;
  for (const std::string& file : experiments::experimentFiles()) {
    try {
      if (auto moved = movedTo(stand, experiments::readExperiment(file))) all.push_back(plainly(std::move(*moved), at));
    } catch (const std::runtime_error&) {
      continue;  // `darwinop experiment list` says what is wrong with it
    }
  }
  addPayloads(at, all);
  for (ExperimentCandidate& candidate : benchCandidates(given, stand)) all.push_back(std::move(candidate));
  return all;
}

}  // namespace darwinop::gap
