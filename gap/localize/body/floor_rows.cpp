// Signals of a robot on the floor against the simulation of the whole robot.
#include "gap/localize/body/floor_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gap/localize/absorb.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

std::vector<BodyRow> floorRows(const BodyCase& given, const FloorResiduals& residuals, const FloorTraces& traces,
                               const ImuDeviation& imu) {
  const Eigen::VectorXd scaled = residuals.scaled(traces, imu), white = residuals.whitened(scaled);
  struct Sums {
    double square = 0, sigma = 0, z = 0, count = 0, common = 0, worst = 0;
  };
  std::array<Sums, kFloorSignals> sums;
  std::vector<BodyRow> rows(kFloorSignals);
  for (const FloorSamples& block : residuals.blocks()) {
    Sums& sum = sums[block.signal];
    BodyRow& row = rows[block.signal];
    const auto span = [&](const Eigen::VectorXd& of) { return of.segment(block.begin, block.rows); };
    sum.square += span(scaled).cwiseProduct(span(residuals.sigma())).squaredNorm();
    sum.sigma += span(residuals.sigma()).squaredNorm();
    // What belongs to another signal is not this one's: whitening spreads it.
    sum.z += std::min(span(white).squaredNorm(), span(scaled).squaredNorm());
    sum.count += static_cast<double>(block.rows);
    sum.common += std::pow(span(residuals.commonShare()).sum() / thresholds::kCorrelatedSamples, 2);
    const BodyLog& log = given.logs[block.log];
    double stretch = 0;
    for (Eigen::Index from = 0, to = 0; to < block.rows; ++to) {
      const auto time = [&](Eigen::Index at) { return log.time_s[static_cast<std::size_t>(at)]; };
      stretch += std::pow(span(white)[to], 2);
      for (; time(to) - time(from) > thresholds::kWorstStretch; ++from) stretch -= std::pow(span(white)[from], 2);
      if (!(stretch > sum.worst)) continue;
      sum.worst = stretch;
      row.file = log.file, row.t0_s = time(from), row.t1_s = time(to);
    }
  }
  for (std::size_t signal = 0; signal < kFloorSignals; ++signal) {
    const Sums& sum = sums[signal];
    BodyRow& row = rows[signal];
    row.signal = floorSignal(signal);
    row.place = {.kind = Place::Kind::kContact, .name = "floor"};
    row.block = Block::kPlant;
    row.unit = std::string{floorUnit(signal)};
    row.size = std::sqrt(sum.square / sum.count), row.floors = std::sqrt(sum.square / sum.sigma);
    // What no run spans has one amplitude a log, however many its samples: fewer degrees of freedom (Satterthwaite).
    const double samples = sum.count / thresholds::kCorrelatedSamples;
    const double freedom = samples * samples / (samples + sum.common);
    row.significance = sigmasOfChiSquared(sum.z / sum.count * freedom, freedom);
  }
  return rows;
}

BodyTable withFloor(BodyTable table, const ClampedRobot& robot) {
  const BodyCase& given = robot.given();
  if (!canSimulateFloor(given)) return table;
  const MovingImu imu{given.joints.model};
  const FloorModel about{.robot = {.robot = robot.baseline(), .floor = {}}};
  const FloorResiduals residuals{given, floorLogs(given, false), imu, about};
  for (BodyRow& row : floorRows(given, residuals, residuals.baseTraces(), about.imu))
    table.rows.push_back(std::move(row));
  return tableOf(std::move(table.rows), given);
}

}  // namespace darwinop::gap
