// What two right models of a robot on the floor differ by, from ensembles of simulations: repeats with noise, other
// physics engines, numbers within their priors.
#include <algorithm>
#include <cmath>
#include <functional>

#include "gap/localize/body/drawn_robot.hpp"
#include "gap/localize/body/floor_residuals.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/registers.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Moving average over rows on either side, within each signal of each log.
Eigen::VectorXd smoothedBlocks(const Eigen::VectorXd& of, const std::vector<FloorSamples>& blocks, int half) {
  Eigen::VectorXd out(of.size());
  for (const FloorSamples& block : blocks)
    for (Eigen::Index i = 0; i < block.rows; ++i) {
      const Eigen::Index from = std::max<Eigen::Index>(0, i - half), to = std::min(block.rows - 1, i + half);
      out[block.begin + i] = of.segment(block.begin + from, to - from + 1).mean();
    }
  return out;
}

struct OtherEngine {
  FloorHypothesis robot;
  EngineNumber number = EngineNumber::kNone;
};

/// The same model as other engines solve it, and with other numbers of its contacts.
std::vector<OtherEngine> otherEngines(const FloorHypothesis& about) {
  std::vector<OtherEngine> out;
  const auto add = [&](auto change, EngineNumber number = EngineNumber::kNone) {
    out.push_back({about, number});
    change(out.back().robot);
  };
  add([](FloorHypothesis& one) { one.engine.pyramidal_friction = true; });
  add([](FloorHypothesis& one) { one.engine.impedance = thresholds::kEngineImpedance; });
  add([](FloorHypothesis& one) { one.engine.step_divisor = 2; });
  add([](FloorHypothesis& one) { one.engine.drop_m = thresholds::kEngineDrop; });
  add([](FloorHypothesis& one) { one.floor.contact_time_factor *= 1 + thresholds::kEngineContactTime; },
      EngineNumber::kContactTime);
  add([](FloorHypothesis& one) { one.floor.contact_time_factor /= 1 + thresholds::kEngineContactTime; },
      EngineNumber::kContactTime);
  add([](FloorHypothesis& one) { one.floor.friction_factor *= 1 - thresholds::kEngineFriction; });
  return out;
}

Eigen::MatrixXd finiteOf(const Eigen::MatrixXd& of) {
  return of.unaryExpr([](double value) { return std::isfinite(value) ? value : 0.0; });
}

/// A reading of a sensor is a sample of a millisecond, and an impact is as short as the contact time: engines whose
/// joints agree to a tick have its peak in another millisecond, and of another height. `at`: readings after a delay.
Eigen::VectorXd varianceOfTiming(const std::function<Eigen::VectorXd(double delay_s)>& at, double contact_s,
                                 double period_s) {
  const int half = static_cast<int>(std::lround(thresholds::kEngineTiming * contact_s / period_s));
  const Eigen::VectorXd here = at(0);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(here.size());
  for (int shift = -half; shift <= half; ++shift)
    variance += finiteOf(at(shift * period_s) - here).cwiseAbs2() / (2 * half + 1);
  return variance;
}

}  // namespace

void FloorResiduals::estimateNoise(const FloorModel& about) {
  Ensemble of = simulateEnsemble(about);
  Eigen::VectorXd sigma = sigmaOf(of.repeats);
  const auto at = [&](double delay_s) {
    ImuDeviation moved = about.imu;
    moved.delay_s += delay_s;
    return readings(base_, moved);
  };
  const double contact_s = given_.joints.model.body.contact_time_s * about.robot.floor.contact_time_factor;
  const Eigen::VectorXd of_timing = varianceOfTiming(at, contact_s, given_.joints.model.servo.firmware_period_s);
  sigma = (sigma.cwiseAbs2() + smoothedBlocks(of_timing, blocks_, thresholds::kNoiseVarianceHalfWindow)).cwiseSqrt();
  noise_ = noiseOf(of, sigma);
  noise_of_own_contact_ = noiseOf(of.without(EngineNumber::kContactTime), std::move(sigma));
}

FloorResiduals::Ensemble FloorResiduals::simulateEnsemble(const FloorModel& about) {
  constexpr int kRuns = thresholds::kFloorNoiseRuns;
  std::vector<FloorHypothesis> exact{about.robot};
  std::vector<EngineNumber> numbers;
  for (OtherEngine& one : otherEngines(about.robot))
    exact.push_back(std::move(one.robot)), numbers.push_back(one.number);
  const std::size_t engines = numbers.size();
  const std::size_t draws = given_.trust.empty() ? 0 : thresholds::kFloorPriorRuns;
  for (FloorHypothesis& one : drawnRobots(given_, about.robot, 1, draws)) exact.push_back(std::move(one));
  std::vector<FloorTraces> traces = simulate(exact);
  std::vector<FloorTraces> repeats(kRuns, FloorTraces(logs_.size()));
  forEach(kRuns * logs_.size(), [&](std::size_t i) {
    const std::size_t run = i / logs_.size(), log = i % logs_.size();
    const Disturbance noise{.seed = (run + 1) * 64 + log};
    repeats[run][log] = rollOut(given_, logs_[log], about.robot, &noise);
  });
  base_ = std::move(traces.front());
  const Eigen::VectorXd here = readings(base_, about.imu);
  const auto differences = [&](const std::vector<FloorTraces>& of, std::size_t from, std::size_t count) {
    Eigen::MatrixXd out(here.size(), static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i)
      out.col(static_cast<Eigen::Index>(i)) = readings(of[from + i], about.imu) - here;
    return finiteOf(out);
  };
  Ensemble out{.repeats = differences(repeats, 0, kRuns),
               .engines = differences(traces, 1, engines),
               .draws = differences(traces, 1 + engines, draws),
               .numbers = std::move(numbers)};
  // Where a limb that lies on the floor comes to rest depends on how an engine lets friction stick.
  for (const FloorSamples& block : blocks_)
    if (given_.logs[block.log].setup == BodySetup::kLying)
      out.engines.middleRows(block.begin, block.rows) *= thresholds::kReleasedFactor;
  return out;
}

// Repeats: what varies from row to row is noise of each sample; what varies slowly stays in the columns.
Eigen::VectorXd FloorResiduals::sigmaOf(Eigen::MatrixXd& repeats) const {
  constexpr int kHalf = thresholds::kNoiseHalfWindow;
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(repeats.rows());
  for (Eigen::Index run = 0; run < repeats.cols(); ++run) {
    const Eigen::VectorXd mean = smoothedBlocks(repeats.col(run), blocks_, kHalf);
    variance += (repeats.col(run) - mean).cwiseAbs2() / static_cast<double>(repeats.cols());
    repeats.col(run) = mean;
  }
  variance =
      smoothedBlocks(variance, blocks_, thresholds::kNoiseVarianceHalfWindow) * ((2 * kHalf + 1.0) / (2 * kHalf));
  const Eigen::Vector3d gyro = readingNoise(given_, ImuSensor::kGyro),
                        accel = readingNoise(given_, ImuSensor::kAccelerometer);
  constexpr double kRounding = kRoundingSigma * kRadPerTick;
  for (const FloorSamples& block : blocks_) {
    auto own = variance.segment(block.begin, block.rows).array();
    const auto axis = static_cast<Eigen::Index>(block.signal - kJoints);
    if (block.signal < kJoints)
      own = own.max(kRounding * kRounding);
    else
      own += axis < 3 ? gyro[axis] * gyro[axis] : accel[axis - 3] * accel[axis - 3];
  }
  return variance.cwiseSqrt();
}

// Columns: repeats, engines, draws, and one bias for each axis of the sensors.
void FloorResiduals::setDirections(const Ensemble& of, Noise& into) const {
  const Eigen::Index runs = of.repeats.cols(), engines = of.engines.cols(), draws = of.draws.cols();
  const Eigen::Index columns = runs + engines + draws;
  into.directions = Eigen::MatrixXd::Zero(into.sigma.size(), columns + 6);
  into.directions.leftCols(runs) = of.repeats * (thresholds::kReleasedFactor / std::sqrt(static_cast<double>(runs)));
  into.directions.middleCols(runs, engines) = of.engines;
  if (draws > 0)
    into.directions.middleCols(runs + engines, draws) =
        of.draws * (thresholds::kFewDrawsFactor / std::sqrt(static_cast<double>(draws)));
  for (const FloorSamples& block : blocks_) {
    if (block.signal < kJoints) continue;
    const auto axis = static_cast<Eigen::Index>(block.signal - kJoints);
    into.directions.col(columns + axis)
        .segment(block.begin, block.rows)
        .setConstant(given_.sigmaOf(axis < 3 ? "imu.gyro_bias_rad_s" : "imu.accel_bias_m_s2"));
  }
  into.directions = into.sigma.cwiseInverse().asDiagonal() * into.directions;
}

// A few runs do not span what one more would do: the part of each that the others leave is noise of each sample.
void FloorResiduals::widenByWhatIsNotSpanned(const Ensemble& of, Noise& into) const {
  const Eigen::Index runs = of.repeats.cols(), engines = of.engines.cols(), draws = of.draws.cols();
  const Eigen::MatrixXd of_one = notSpannedByOthers(into.directions).cwiseAbs2();
  Eigen::VectorXd left = of_one.leftCols(runs).rowwise().sum();
  left += of_one.middleCols(runs, engines).rowwise().mean();
  left += of_one.middleCols(runs + engines, draws).rowwise().sum();
  const Eigen::VectorXd factor =
      (1 + smoothedBlocks(left, blocks_, thresholds::kNoiseVarianceHalfWindow).array()).sqrt();
  into.sigma = into.sigma.cwiseProduct(factor);
  into.common = 1 - factor.array().square().inverse();
  into.directions = factor.cwiseInverse().asDiagonal() * into.directions;
}

}  // namespace darwinop::gap
