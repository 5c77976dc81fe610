// Projected Gauss-Seidel (Catto, Iterative Dynamics, 2005): joints barely couple through their armatures, so a few
// sweeps suffice.
#include "gap/plant/body/dry_friction.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::gap {
namespace {

constexpr int kMostSweeps = 60;
constexpr double kSettled = 1e-9;  // rad/s

}  // namespace

LimbVector withFriction(const LimbVector& free, const LimbMatrix& inverse, const LimbVector& greatest,
                        const LimbVector& low, const LimbVector& high, JointImpulses& impulses) {
  const Eigen::Index n = free.size();
  for (Eigen::Index i = 0; i < n; ++i)
    impulses.friction[i] = std::clamp(impulses.friction[i], -greatest[i], greatest[i]);
  LimbVector velocity = free + inverse * (impulses.friction + impulses.stop);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double greatest_change = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double before = impulses.friction[i] + impulses.stop[i];
      const double own = inverse(i, i);
      const double rest = velocity[i] - own * before;  // without impulses of this joint
      const double braked = std::clamp(-rest / own, -greatest[i], greatest[i]);
      const double slid = rest + own * braked;
      impulses.friction[i] = braked;
      impulses.stop[i] = (std::clamp(slid, low[i], high[i]) - slid) / own;
      const double change = impulses.friction[i] + impulses.stop[i] - before;
      if (change == 0) continue;
      velocity += inverse.col(i) * change;
      greatest_change = std::max(greatest_change, std::abs(change) * own);
    }
    if (greatest_change < kSettled) break;
  }
  for (Eigen::Index i = 0; i < n; ++i)
    if (std::abs(impulses.friction[i]) < greatest[i] && impulses.stop[i] == 0) velocity[i] = 0;
  return velocity;
}

}  // namespace darwinop::gap
