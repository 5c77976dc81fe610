#include "apps/calibrate/joints/offset_fit.hpp"

#include <algorithm>
#include <cmath>

#include "apps/calibrate/least_squares.hpp"
#include "core/servo_limits.hpp"

namespace darwinop::calibrate {
namespace {

// Priors, standard deviations. A horn that is mounted one tooth off is off by 14 deg and has to be remounted, so
// offsets are a few degrees. What a unit of gain and a volt make of an error differs between sources by a factor of
// two.
constexpr double kOffsetPrior = 0.1;  // rad
constexpr double kScalePrior = 0.5;   // of the logarithm
// 0.2 deg is promised. The rounding of the encoder averages out faster than the white noise that these deviations
// assume: with up to 0.14 deg the greatest error of 60 joints of three twins was 0.14 deg, and chi2 a seventh of the
// degrees of freedom (calibrate_joints_test).
constexpr double kObservedSigma = 0.15 * kRadPerDegree;

/// One limb: joints, and the points that were measured at them.
class LimbFit {
 public:
  LimbFit(const Limb& limb, const std::vector<GravityPoint>& points, GravityModel& gravity) : gravity_{gravity} {
    for (const Joint joint : limb)
      if (std::ranges::find(points, joint, &GravityPoint::joint) != points.end()) joints_.push_back(joint);
    for (const GravityPoint& point : points)
      if (std::ranges::find(joints_, point.joint) != joints_.end()) points_.push_back(point);
  }

  void append(std::vector<JointOffset>& out) {
    if (joints_.empty()) return;
    const std::size_t count = joints_.size();
    const LeastSquares fit = leastSquares([this](const std::vector<double>& x) { return residuals(x); },
                                          std::vector<double>(2 * count), std::vector<double>(2 * count, 1e-4));
    // What the model does not explain widens every interval of the limb.
    const double spare = std::max(1.0, static_cast<double>(points_.size()) - 2.0 * static_cast<double>(count));
    const double excess = std::sqrt(std::max(1.0, fit.cost / spare));
    for (std::size_t i = 0; i < count; ++i) {
      const double sigma = fit.sigmas[i] * excess;
      out.push_back({joints_[i], fit.values[i], sigma, sigma <= kObservedSigma});
    }
  }

 private:
  [[nodiscard]] std::vector<double> residuals(const std::vector<double>& x) {
    std::vector<double> out;
    for (const GravityPoint& point : points_) {
      JointValues angles = point.angles_rad;
      for (std::size_t i = 0; i < joints_.size(); ++i) angles[index(joints_[i])] -= x[i];
      const auto at = static_cast<std::size_t>(std::ranges::find(joints_, point.joint) - joints_.begin());
      const double scale = std::exp(x[joints_.size() + at]) / kMaxTorqueNm;
      const double torque = gravity_.holdingTorques(angles, point.up)[index(point.joint)];
      out.push_back((point.load - scale * torque) / point.sigma);
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      out.push_back(x[i] / kOffsetPrior);
      out.push_back(x[joints_.size() + i] / kScalePrior);
    }
    return out;
  }

  std::vector<Joint> joints_;
  std::vector<GravityPoint> points_;
  GravityModel& gravity_;
};

}  // namespace

std::vector<JointOffset> fitOffsets(const std::vector<GravityPoint>& points, GravityModel& gravity) {
  std::vector<JointOffset> out;
  for (const Limb& limb : limbs()) LimbFit{limb, points, gravity}.append(out);
  std::ranges::sort(out, {}, [](const JointOffset& one) { return index(one.joint); });
  return out;
}

}  // namespace darwinop::calibrate
