#include "gap/fit/noise.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/conversions.hpp"
#include "gap/fit/bifurcation.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/registers.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNotCounted = std::numeric_limits<double>::infinity();  // sigma
const double kUniform = std::sqrt(1.0 / 12);                             // standard deviation of a rounding step of 1

/// Mean over a window that is cut at the ends.
Eigen::VectorXd smoothed(const Eigen::Ref<const Eigen::VectorXd>& values, Eigen::Index half) {
  const Eigen::Index n = values.size();
  Eigen::VectorXd mean(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - half), to = std::min(n - 1, i + half);
    mean[i] = values.segment(from, to - from + 1).mean();
  }
  return mean;
}

/// Deviations of the runs with noise from the one without: positions above loads, a column a run.
Eigen::MatrixXd deviations(const Plant& plant, const Case& given, std::size_t log, const Hypothesis& hypothesis,
                           const NoiseOptions& options, const Trace& quiet, const LoadResidual& load_residual) {
  const auto n = static_cast<Eigen::Index>(given.logs[log].rows());
  const double step = loadStepOf(given.logs[log]);
  Eigen::MatrixXd all(2 * n, options.runs);
  Trace noisy;
  for (int run = 0; run < options.runs; ++run) {
    Disturbance disturbance = options.disturbance;
    disturbance.seed = (options.seed * 1'000 + log) * 1'000 + static_cast<std::uint64_t>(run);
    plant.rollOut(given, log, hypothesis, {.disturbance = &disturbance}, noisy);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto row = static_cast<std::size_t>(i);
      all(i, run) = noisy[kPositionSignal][row] - quiet[kPositionSignal][row];
      const double load = std::round(noisy[kLoadSignal][row] / step) * step;
      all(n + i, run) =
          load_residual(load, noisy[kPositionSignal][row], quiet[kLoadSignal][row], quiet[kPositionSignal][row]);
    }
  }
  return all;
}

/// Takes the rough part out of `part`; returns its standard deviation.
Eigen::VectorXd takeRoughness(Eigen::Ref<Eigen::MatrixXd> part) {
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(part.rows());
  constexpr double kLost =
      1 + 1.0 / (2 * thresholds::kNoiseHalfWindow);  // of a white noise's variance, by taking the mean away
  for (Eigen::Index run = 0; run < part.cols(); ++run) {
    const Eigen::VectorXd smooth = smoothed(part.col(run), thresholds::kNoiseHalfWindow);
    variance += kLost * (part.col(run) - smooth).cwiseAbs2() / static_cast<double>(part.cols());
    part.col(run) = smooth;
  }
  return smoothed(variance, thresholds::kNoiseVarianceHalfWindow).cwiseSqrt();
}

/// Uncertainty of each load: it is that of the last firmware period before the read, which is known to one period only.
Eigen::VectorXd loadJitter(const Trajectory& log, const Trace& quiet, double period_s) {
  const auto n = static_cast<Eigen::Index>(log.rows());
  Eigen::VectorXd jitter = Eigen::VectorXd::Zero(n);
  for (std::size_t row = 1; row < log.rows(); ++row) {
    const double rate =
        std::abs(quiet[kLoadSignal][row] - quiet[kLoadSignal][row - 1]) / (log.time_s[row] - log.time_s[row - 1]);
    for (const std::size_t at : {row - 1, row})
      jitter[static_cast<Eigen::Index>(at)] =
          std::max(jitter[static_cast<Eigen::Index>(at)], rate * period_s * kUniform);
  }
  return jitter;
}

}  // namespace

LogNoise::LogNoise(const Plant& plant, const Case& given, std::size_t log, const Hypothesis& hypothesis,
                   const NoiseOptions& options)
    : load_residual_{hypothesis, given.logs[log].p_register} {
  const Trajectory& measured = given.logs[log];
  const auto n = static_cast<Eigen::Index>(measured.rows());
  Trace quiet;
  plant.rollOut(given, log, hypothesis, {}, quiet);
  Eigen::MatrixXd spread = deviations(plant, given, log, hypothesis, options, quiet, load_residual_);
  const double tick = 2 * kPi / hypothesis.servo.ticks_per_rev;
  const double reading = tick * std::hypot(kUniform, options.disturbance.encoder_ticks);
  position_sigma_ = takeRoughness(spread.topRows(n)).cwiseMax(reading);
  const double gain = hypothesis.servo.duty_per_kp_per_rad * measured.p_register;
  const double duty = std::hypot(gain * reading, loadStepOf(measured) * kUniform);
  load_sigma_ = takeRoughness(spread.bottomRows(n)).cwiseMax(duty);
  load_sigma_ = load_sigma_.cwiseAbs2() + loadJitter(measured, quiet, hypothesis.servo.firmware_period_s).cwiseAbs2();
  load_sigma_ = load_sigma_.cwiseSqrt().eval();
  // The torque feedback of law speed_p belongs to the ideal motor of that law, which no servo has.
  if (!loadIsDuty(hypothesis)) load_sigma_.setConstant(kNotCounted);
  // What was not measured has no part in the modes, nor in the determinant, which is compared between hypotheses.
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (std::isnan(measured.position_rad[row])) position_sigma_[i] = load_sigma_[i] = kNotCounted;
    if (std::isnan(measured.load[row])) load_sigma_[i] = kNotCounted;
  }

  // What repeats of a release differ by where the model knows of no such difference.
  const double rest_sigma_rad = std::sqrt(spread.row(n - 1).squaredNorm() / static_cast<double>(options.runs));
  const Eigen::MatrixXd bifurcation = bifurcationOf(given, log, rest_sigma_rad);
  bifurcates_ = bifurcation.cols() > 0;
  if (bifurcates_) {
    const Eigen::Index runs = spread.cols();
    spread.conservativeResize(Eigen::NoChange, runs + bifurcation.cols());
    spread.rightCols(bifurcation.cols()).setZero();
    spread.topRightCorner(n, bifurcation.cols()) =
        bifurcation * std::sqrt(static_cast<double>(options.runs) / static_cast<double>(bifurcation.cols()));
  }
  spread.topRows(n).array().colwise() /= position_sigma_.array();
  spread.bottomRows(n).array().colwise() /= load_sigma_.array();
  spread /= std::sqrt(static_cast<double>(options.runs));
  // Singular vectors by way of the small matrix of the runs. That loses modes below 1e-8 of the largest, which do not
  // count; Eigen's SVD would take most of the time of compiling this room.
  const Eigen::MatrixXd runs = spread.transpose() * spread;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen{runs};  // ascending
  const Eigen::VectorXd sigmas = eigen.eigenvalues().cwiseMax(0).cwiseSqrt();
  const Eigen::Index count = (sigmas.array() > thresholds::kSmallestNoiseMode).count();
  const Eigen::VectorXd kept = sigmas.tail(count);
  modes_ = spread * (eigen.eigenvectors().rightCols(count) * kept.cwiseInverse().asDiagonal());
  mode_sigma_ = thresholds::kFewRunsFactor * kept;
  if (options.discrepancy.any())
    addDiscrepancy(options.discrepancy, log, measured.duration_s() / static_cast<double>(n - 1));
}

// The drift of a right model is far smaller than this discrepancy: it needs no modes of its own.
void LogNoise::addDiscrepancy(const Discrepancy& discrepancy, std::size_t log, double period_s) {
  const Eigen::Index n = position_sigma_.size();
  const Eigen::ArrayXd drift = (modes_ * mode_sigma_.asDiagonal()).rowwise().squaredNorm();
  const auto widen = [](Eigen::VectorXd& sigma, const auto& part, double more) {
    sigma = (sigma.array().square() * (1 + part) + more * more).sqrt().matrix();
  };
  widen(position_sigma_, drift.head(n), discrepancy.position_rad);
  widen(load_sigma_, drift.tail(n), discrepancy.load[log]);
  modes_.resize(2 * n, 0);
  mode_sigma_.resize(0);
  correlated_samples_ = std::max(1.0, discrepancy.correlation_s / period_s);
}

void LogNoise::residuals(const Trajectory& measured, const Trace& simulated, Eigen::Ref<Eigen::VectorXd> out) const {
  const Eigen::Index n = position_sigma_.size();
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const double position = (measured.position_rad[row] - simulated[kPositionSignal][row]) / position_sigma_[i];
    const double load = load_residual_(measured.load[row], measured.position_rad[row], simulated[kLoadSignal][row],
                                       simulated[kPositionSignal][row]) /
                        load_sigma_[i];
    out[i] = std::isfinite(position) ? position : 0;
    out[n + i] = std::isfinite(load) ? load : 0;
  }
  if (correlated_samples_ > 0) out = out.unaryExpr(&softened) / std::sqrt(correlated_samples_);
  if (mode_sigma_.size() == 0) return;
  // C = 1 + U s2 U': its inverse root takes from each mode what exceeds 1.
  const Eigen::VectorXd in_modes = modes_.transpose() * out;
  const Eigen::ArrayXd excess = 1 - (1 + mode_sigma_.array().square()).rsqrt();
  out -= modes_ * (excess * in_modes.array()).matrix();
}

double LogNoise::logDeterminant() const {
  double sum = (1 + mode_sigma_.array().square()).log().sum();
  for (const Eigen::VectorXd* const sigmas : {&position_sigma_, &load_sigma_})
    for (const double sigma : *sigmas)
      if (std::isfinite(sigma)) sum += 2 * std::log(sigma);
  return correlated_samples_ > 0 ? sum / correlated_samples_ : sum;
}

Eigen::VectorXd LogNoise::positionSigma() const {
  const Eigen::Index n = position_sigma_.size();
  const Eigen::ArrayXd together = (modes_.topRows(n) * mode_sigma_.asDiagonal()).rowwise().squaredNorm();
  return (position_sigma_.array() * (1 + together).sqrt()).matrix();
}

RmsSum LogNoise::positionFloor() const {
  RmsSum sum;
  for (const double sigma : positionSigma())
    if (std::isfinite(sigma)) sum.squares += sigma * sigma, sum.rows += 1;
  return sum;
}

std::vector<LogNoise> noiseOf(const Plant& plant, const Case& given, const std::vector<std::size_t>& logs,
                              const Hypothesis& hypothesis, const NoiseOptions& options) {
  std::vector<std::optional<LogNoise>> found(logs.size());
  forEach(logs.size(), [&](std::size_t i) { found[i].emplace(plant, given, logs[i], hypothesis, options); });
  std::vector<LogNoise> noise;
  noise.reserve(logs.size());
  for (auto& one : found) noise.push_back(std::move(*one));
  return noise;
}

}  // namespace darwinop::gap
