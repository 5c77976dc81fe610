#include "gap/localize/intervals.hpp"

#include <algorithm>
#include <cmath>

#include "gap/plant/row_state.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

double rms(const Eigen::VectorXd& values, const EnergyInterval& at) {
  double sum = 0, count = 0;
  for (std::size_t i = at.first; i <= at.last; ++i) {
    const double value = values[static_cast<Eigen::Index>(i)];
    if (!std::isnan(value)) sum += value * value, count += 1;
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

/// The open block whose cut stands out most around these rows of one log.
std::optional<Block> worstBlock(const Blocks& blocks, std::size_t i, std::size_t first, std::size_t last) {
  std::optional<Block> worst;
  double greatest = 2;  // mean of squares: closed there below it
  for (const BlockFinding& block : blocks.all) {
    if (block.verdict != BlockVerdict::kOpen || block.samples.empty()) continue;
    const BlockResiduals& samples = block.samples[i];
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < samples.row.size(); ++k)
      if (samples.row[k] >= first && samples.row[k] <= last)
        sum += std::pow(samples.z[static_cast<Eigen::Index>(k)], 2), count += 1;
    if (count > 0 && sum / count > greatest) greatest = sum / count, worst = block.block;
  }
  return worst;
}

struct Signal {
  const char* name;
  const char* unit;
  double per_unit;
};

void addPlaces(const Case& given, const std::vector<LogResidual>& residuals, const Blocks& blocks, const Signal& signal,
               const std::vector<Eigen::VectorXd>& z, const std::vector<Eigen::VectorXd>& values, std::size_t most,
               std::vector<GapInterval>& into) {
  std::vector<std::vector<double>> times;
  times.reserve(residuals.size());
  for (const LogResidual& one : residuals) times.push_back(given.logs[one.log].time_s);
  const auto found = scanEnergy(z, times);
  std::vector<GapInterval> places;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Trajectory& log = given.logs[residuals[i].log];
    for (const EnergyInterval& at : found[i])
      places.push_back({.signal = signal.name,
                        .joint = "",
                        .file = log.file,
                        .t0_s = log.time_s[at.first],
                        .t1_s = log.time_s[at.last],
                        .happens = whatHappens(log, at.first, at.last, given.model.servo),
                        .block = worstBlock(blocks, i, at.first, at.last),
                        .chi2 = at.chi2,
                        .samples = static_cast<double>(at.last - at.first + 1),
                        .size = rms(values[i], at) / signal.per_unit,
                        .unit = signal.unit});
  }
  std::ranges::sort(places, std::greater{}, &GapInterval::score);
  if (places.size() > most) places.resize(most);
  into.insert(into.end(), places.begin(), places.end());
}

void addPlacesOf(const BlockFinding& block, const Case& given, const std::vector<LogResidual>& residuals,
                 const Blocks& blocks, const Signal& signal, std::vector<GapInterval>& into) {
  if (block.verdict != BlockVerdict::kOpen || block.samples.empty()) return;
  std::vector<Eigen::VectorXd> z, values;
  for (const BlockResiduals& samples : block.samples) {
    if (samples.row.size() != given.logs[residuals[z.size()].log].rows()) return;  // windows, not rows
    z.push_back(samples.z);
    values.push_back(samples.residual);
  }
  addPlaces(given, residuals, blocks, signal, z, values, thresholds::kMostBlockIntervals / 2, into);
}

}  // namespace

double GapInterval::score() const {
  return (chi2 - samples) / std::sqrt(2 * samples);
}

std::string whatHappens(const Trajectory& log, std::size_t first, std::size_t last,
                        const twin::ServoParameters& servo) {
  bool step = false;
  double limp = 0, full = 0, fastest = 0, forth = 0, back = 0;
  std::size_t from = first;
  while (from > 0 && log.time_s[first] - log.time_s[from - 1] <= thresholds::kAfterGoalStep) --from;
  for (std::size_t row = std::max<std::size_t>(from, 1); row <= last; ++row)
    step = step ||
           (log.torque_on[row] != 0 && std::abs(log.goal_rad[row] - log.goal_rad[row - 1]) > thresholds::kGoalStep);
  for (std::size_t row = first; row <= last; ++row) {
    const double speed = stateAt(log, row).speed_rad_s;
    limp += log.torque_on[row] == 0 ? 1 : 0;
    full += std::abs(log.load[row]) >= thresholds::kFullDutyShare * servo.duty_max ? 1 : 0;
    fastest = std::max(fastest, std::abs(speed));
    forth = std::max(forth, speed), back = std::max(back, -speed);
  }
  const double rows = static_cast<double>(last - first + 1);
  if (limp > thresholds::kLimpShare * rows) return "torque off";
  if (step) return full > thresholds::kSaturatedShare * rows ? "saturation" : "step";
  if (full > thresholds::kSaturatedShare * rows) return "saturation";
  if (fastest < thresholds::kRestSpeed) return "rest";
  if (std::min(forth, back) > thresholds::kRestSpeed) return "reversal";
  return fastest < thresholds::kSlowSpeed ? "slow motion" : "motion";
}

std::vector<GapInterval> intervalsOf(const Case& given, const std::vector<LogResidual>& residuals,
                                     const Blocks& blocks) {
  std::vector<GapInterval> out, others;
  std::vector<Eigen::VectorXd> z, values;
  for (const LogResidual& one : residuals) z.push_back(one.z), values.push_back(one.position_rad);
  const Block law = blocks.of(Block::kCommand).verdict == BlockVerdict::kOpen ? Block::kCommand : Block::kController;
  addPlacesOf(blocks.of(law), given, residuals, blocks, {"load", "%", 0.01}, others);
  addPlacesOf(blocks.of(Block::kSupply), given, residuals, blocks, {"volt", "V", 1}, others);
  addPlaces(given, residuals, blocks, {"position", "mrad", 1e-3}, z, values, thresholds::kMostIntervals - others.size(),
            out);
  out.insert(out.end(), others.begin(), others.end());
  return out;
}

}  // namespace darwinop::gap
