// Controller and supply of each joint, from its own signals.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/registers.hpp"
#include "gap/localize/absorb.hpp"
#include "gap/localize/body/body_table.hpp"
#include "gap/localize/fit_nuisances.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "gap/plant/registers.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Joint logs of all recordings that are not held out: indices in BodyCase::joints.
std::vector<std::size_t> fittedJointLogs(const BodyCase& given) {
  std::vector<std::size_t> logs;
  for (std::size_t i = 0; i < given.joints.logs.size(); ++i)
    if (!given.joints.logs[i].held_out) logs.push_back(i);
  return logs;
}

constexpr double kBoardStep = find(kCm730, "voltage").scale;  // V

/// The supply is what the board measured where that is known: a battery with a resistance has less for all servos.
void useBoardSupply(const BodyLog& log, BlockResiduals& samples) {
  for (std::size_t k = 0; k < samples.row.size(); ++k) {
    const std::size_t row = samples.row[k];
    if (row >= log.board_v.size() || std::isnan(log.board_v[row])) continue;
    const auto at = static_cast<Eigen::Index>(k);
    samples.residual[at] += log.battery_v - log.board_v[row];
    samples.sigma[at] = std::hypot(samples.sigma[at], kBoardStep * kRoundingSigma);
  }
}

/// A servo and the board look at the supply at different moments of a cycle, in which the current of all servos
/// changes: how far apart that takes them is what the other servos show.
void widenByOtherServos(std::vector<BlockResiduals>& samples) {
  struct Moments {
    double n = 0, sum = 0, squares = 0;
  };
  std::array<Moments, kJoints> of_joint;
  Moments all;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (const double residual : samples[i].residual) {
      if (std::isnan(residual)) continue;
      for (Moments* const to : {&of_joint[i % kJoints], &all})
        to->n += 1, to->sum += residual, to->squares += residual * residual;
    }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Moments& own = of_joint[i % kJoints];
    const double n = all.n - own.n;
    if (n == 0) continue;
    const double mean = (all.sum - own.sum) / n, variance = (all.squares - own.squares) / n - mean * mean;
    for (double& sigma : samples[i].sigma) sigma = std::max(sigma, std::sqrt(std::max(variance, 0.0)));
  }
}

/// Residuals of one block in each of `logs`; z after what numbers inside their priors explain, the same for all servos.
std::vector<BlockResiduals> samplesOf(Block block, const BodyCase& given, const std::vector<std::size_t>& logs,
                                      bool has_board_supply) {
  const Hypothesis robot = bodyBaselineOf(given);
  const BlockResidualFunction cut = [&](const Trajectory& log, const Hypothesis& hypothesis) {
    return jointResiduals(block, given, log, hypothesis);
  };
  std::vector<BlockResiduals> samples(logs.size());
  forEach(logs.size(), [&](std::size_t i) {
    samples[i] = cut(given.joints.logs[logs[i]], robot);
    if (block == Block::kSupply && has_board_supply) useBoardSupply(given.logs[logs[i] / kJoints], samples[i]);
  });
  if (block == Block::kSupply && has_board_supply) widenByOtherServos(samples);
  for (BlockResiduals& of : samples)
    for (Eigen::Index k = 0; k < of.z.size(); ++k)
      of.z[k] = std::isnan(of.residual[k]) ? 0 : of.residual[k] / of.sigma[k];
  // Of the numbers with a prior, only this one is in a block: motor and load are in the plant.
  std::vector<Unknown> numbers = nuisancesOf(given.joints, robot);
  std::erase_if(numbers,
                [&](const Unknown& number) { return block != Block::kController || number.name != "duty_per_kp"; });
  if (!numbers.empty()) (void)fitNuisances(cut, given.joints, logs, robot, numbers, samples);
  return samples;
}

/// The stretch of half a second with the greatest sum of squares.
void locate(const BlockResiduals& samples, const Trajectory& log, double& greatest, BodyRow& into) {
  std::size_t from = 0;
  double sum = 0;
  for (std::size_t to = 0; to < samples.row.size(); ++to) {
    const auto square = [&](std::size_t k) { return std::pow(samples.z[static_cast<Eigen::Index>(k)], 2); };
    const auto time = [&](std::size_t k) { return log.time_s[samples.row[k]]; };
    sum += square(to);
    for (; time(to) - time(from) > thresholds::kWorstStretch; ++from) sum -= square(from);
    if (!(sum > greatest)) continue;
    greatest = sum;
    into.file = log.file, into.t0_s = time(from), into.t1_s = time(to);
  }
}

struct Squares {
  double residual = 0, sigma = 0, z = 0, count = 0, worst = 0;
};

void add(const BlockResiduals& samples, Squares& to) {
  for (Eigen::Index k = 0; k < samples.z.size(); ++k) {
    if (std::isnan(samples.residual[k])) continue;
    to.residual += samples.residual[k] * samples.residual[k];
    to.sigma += samples.sigma[k] * samples.sigma[k];
    to.z += samples.z[k] * samples.z[k];
    to.count += 1;
  }
}

}  // namespace

std::vector<BodyRow> jointRows(const BodyCase& given, bool has_board_supply) {
  const std::vector<std::size_t> logs = fittedJointLogs(given);
  std::vector<BodyRow> rows;
  for (const Block block : kBlocksOfJointAlone) {
    const std::vector<BlockResiduals> samples = samplesOf(block, given, logs, has_board_supply);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      const std::string name{kJointTable[joint].name};
      BodyRow row{.signal = name + (block == Block::kSupply ? ".voltage" : ".load"),
                  .place = {.kind = Place::Kind::kJoint, .name = name},
                  .block = block,
                  .unit = block == Block::kSupply ? "V" : ""};
      Squares all;
      for (std::size_t i = joint; i < logs.size(); i += kJoints) {
        add(samples[i], all);
        locate(samples[i], given.joints.logs[logs[i]], all.worst, row);
      }
      if (!(all.count > thresholds::kCorrelatedSamples)) continue;
      row.size = std::sqrt(all.residual / all.count);
      row.floors = std::sqrt(all.residual / all.sigma);
      // What one row has of an effect, its neighbours have as well.
      row.significance =
          sigmasOfChiSquared(all.z / thresholds::kCorrelatedSamples, all.count / thresholds::kCorrelatedSamples);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace darwinop::gap
