#include "gap/localize/body/limb_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "gap/case/body/row_law.hpp"
#include "gap/localize/body/stop_contact.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

bool sameCommands(const BodyCase& given, const Limb& limb, std::size_t a, std::size_t b) {
  if (given.logs[a].up != given.logs[b].up || given.logs[a].battery_v != given.logs[b].battery_v) return false;
  return std::ranges::all_of(limb, [&](const Link& link) {
    const auto j = static_cast<std::size_t>(link.joint);
    const Trajectory &one = given.joint(a, j), &other = given.joint(b, j);
    return one.time_s == other.time_s && one.goal_rad == other.goal_rad && one.torque_on == other.torque_on &&
           one.p_register_of_row == other.p_register_of_row;
  });
}

}  // namespace

std::vector<std::size_t> clampedLogs(const BodyCase& given, bool held_out) {
  std::vector<std::size_t> logs;
  for (std::size_t i = 0; i < given.logs.size(); ++i)
    if (given.logs[i].up && given.logs[i].held_out == held_out) logs.push_back(i);
  return logs;
}

LimbResiduals::LimbResiduals(const BodyCase& given, std::vector<std::size_t> logs, const Limb& limb,
                             const BodyHypothesis& about, Eigen::VectorXd numbers)
    : given_{given},
      limb_{limb},
      logs_{std::move(logs)},
      nuisances_{nuisancesOf(given, limb)},
      numbers_{std::move(numbers)} {
  if (numbers_.size() == 0) numbers_ = Eigen::VectorXd::Zero(std::ssize(nuisances_));
  Eigen::Index size = 0;
  for (const std::size_t log : logs_)
    for (std::size_t joint = 0; joint < limb_.size(); ++joint)
      for (const bool is_load : {false, true}) {
        const auto rows = static_cast<Eigen::Index>(given.logs[log].rows());
        blocks_.push_back({log, static_cast<Eigen::Index>(joint), is_load, size, rows});
        size += rows;
      }
  measured_.resize(size);
  std::map<std::size_t, std::vector<std::vector<bool>>> lost;
  for (const std::size_t log : logs_) lost[log] = lostAtStops(given, log, limb_);
  for (const LimbSamples& block : blocks_) {
    const Trajectory& rows = given.joint(block.log, jointOf(block));
    const std::vector<bool>& is_lost = lost.at(block.log)[static_cast<std::size_t>(block.joint)];
    for (Eigen::Index row = 0; row < block.rows; ++row) {
      const auto r = static_cast<std::size_t>(row);
      measured_[block.begin + row] =
          block.is_load ? rows.load[r] - lawAt(given, rows, r, rows.position_rad[r]) : rows.position_rad[r];
      if (is_lost[r] && !block.is_load) measured_[block.begin + row] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  if (!isRecorded(given, limb_)) measured_.setConstant(std::numeric_limits<double>::quiet_NaN());
  estimateNoise(moved(about, numbers_));
  addPriors(about);
  forgetUnmeasured(measured_, directions_);
  modes_ = NoiseModes{directions_};
}

Eigen::VectorXd LimbResiduals::simulated(const BodyHypothesis& hypothesis, const Disturbance* noise) const {
  Eigen::VectorXd out(measured_.size());
  std::vector<LimbTrace> traces(logs_.size());
  for (std::size_t i = 0; i < logs_.size(); ++i) {
    std::size_t like = 0;
    while (like < i && (noise != nullptr || !sameCommands(given_, limb_, logs_[like], logs_[i]))) ++like;
    if (like < i) {
      traces[i] = traces[like];
      continue;
    }
    Disturbance own = noise == nullptr ? Disturbance{} : *noise;
    own.seed = own.seed * 64 + i;
    traces[i] = rollOut(given_, logs_[i], limb_, hypothesis, noise == nullptr ? nullptr : &own);
  }
  for (const LimbSamples& block : blocks_) {
    const auto at = static_cast<std::size_t>(std::ranges::find(logs_, block.log) - logs_.begin());
    const LimbTrace& trace = traces[at];
    const Trajectory& rows = given_.joint(block.log, jointOf(block));
    for (Eigen::Index row = 0; row < block.rows; ++row) {
      const double position = trace.position_rad(row, block.joint);
      out[block.begin + row] =
          block.is_load ? trace.duty(row, block.joint) - lawAt(given_, rows, static_cast<std::size_t>(row), position)
                        : position;
    }
  }
  return out;
}

}  // namespace darwinop::gap
