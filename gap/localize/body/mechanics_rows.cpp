// Position of each joint against the simulation of its limb, while the trunk is clamped.
#include <algorithm>
#include <cmath>

#include "gap/localize/absorb.hpp"
#include "gap/localize/body/body_table.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

std::vector<BodyRow> mechanicsRows(const ClampedRobot& robot, const BodyHypothesis& hypothesis) {
  std::vector<BodyRow> rows;
  if (!robot.isTestable()) return rows;
  for (std::size_t limb = 0; limb < robot.limbs().size(); ++limb)
    for (BodyRow& row : limbRows(robot, limb, hypothesis)) rows.push_back(std::move(row));
  return rows;
}

std::vector<BodyRow> limbRows(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& hypothesis) {
  std::vector<BodyRow> rows;
  const LimbResiduals& residuals = robot.residuals(limb);
  const Eigen::VectorXd scaled = residuals.scaled(hypothesis), white = residuals.whitened(scaled);
  for (std::size_t joint = 0; joint < robot.limbs()[limb].size(); ++joint) {
    const std::string name{kJointTable[static_cast<std::size_t>(robot.limbs()[limb][joint].joint)].name};
    BodyRow row{.signal = name + ".position",
                .place = {.kind = Place::Kind::kJoint, .name = name},
                .block = Block::kPlant,
                .unit = "rad",
                .is_measured = isRecorded(robot.given(), robot.limbs()[limb])};
    double square = 0, sigma = 0, z = 0, count = 0, worst = 0;
    for (const LimbSamples& block : residuals.blocks()) {
      if (block.is_load || block.joint != static_cast<Eigen::Index>(joint)) continue;
      const auto span = [&](const Eigen::VectorXd& of) { return of.segment(block.begin, block.rows); };
      square += span(scaled).cwiseProduct(span(residuals.sigma())).squaredNorm();
      sigma += span(residuals.sigma()).squaredNorm();
      // What belongs to a neighbour is not this joint's: whitening spreads it.
      z += std::min(span(white).squaredNorm(), span(scaled).squaredNorm()), count += static_cast<double>(block.rows);
      const BodyLog& log = robot.given().logs[block.log];
      double sum = 0;
      for (Eigen::Index from = 0, to = 0; to < block.rows; ++to) {
        const auto time = [&](Eigen::Index at) { return log.time_s[static_cast<std::size_t>(at)]; };
        sum += std::pow(span(white)[to], 2);
        for (; time(to) - time(from) > thresholds::kWorstStretch; ++from) sum -= std::pow(span(white)[from], 2);
        if (!(sum > worst)) continue;
        worst = sum;
        row.file = log.file, row.t0_s = time(from), row.t1_s = time(to);
      }
    }
    row.size = std::sqrt(square / count), row.floors = std::sqrt(square / sigma);
    row.significance = sigmasOfChiSquared(z / thresholds::kCorrelatedSamples, count / thresholds::kCorrelatedSamples);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace darwinop::gap
