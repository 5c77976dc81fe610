#include "gap/benchmark/body/soft_rows.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace darwinop::gap {
namespace {

constexpr int kRounds = 8;         // of finding out which rows are at their limit
constexpr double kSettled = 1e-6;  // change of a share from which the rounds go on

double springForce(const SoftRow& row, double speed, double dt_s) {
  return -row.stiffness * (row.bend + dt_s * speed) - row.damping * speed;
}

double shareOf(const std::vector<SoftRow>& rows, std::size_t i, const std::vector<double>& spring) {
  const SoftRow& row = rows[i];
  if (row.only_pushes) return spring[i] > 0 ? 1 : 0;
  const double size = row.normal < 0 ? std::abs(spring[i]) : std::hypot(spring[i], spring[i + 1]);
  const double limit =
      row.normal < 0 ? row.limit : row.limit * std::max(0.0, rows[static_cast<std::size_t>(row.normal)].force);
  return size > limit ? limit / size : 1;
}

}  // namespace

Eigen::VectorXd stepped(const Eigen::MatrixXd& mass, const Eigen::VectorXd& damping, const Eigen::VectorXd& velocity,
                        const Eigen::VectorXd& force, double dt_s, std::vector<SoftRow>& rows) {
  Eigen::MatrixXd base = mass;
  base.diagonal() += dt_s * damping;
  const Eigen::VectorXd push = mass * velocity + dt_s * force;
  std::vector<double> share(rows.size(), 1), spring(rows.size(), 0);
  Eigen::VectorXd v = velocity;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::MatrixXd left = base;
    Eigen::VectorXd right = push;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const SoftRow& row = rows[i];
      if (share[i] == 0) continue;
      const double gain = share[i] * (dt_s * row.stiffness + row.damping);
      left.selfadjointView<Eigen::Lower>().rankUpdate(row.direction, dt_s * gain);
      right -= dt_s * share[i] * row.stiffness * row.bend * row.direction;
    }
    v = left.selfadjointView<Eigen::Lower>().llt().solve(right);
    double change = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      spring[i] = springForce(rows[i], rows[i].direction.dot(v), dt_s);
      rows[i].force = share[i] * spring[i];
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      // The second sideways row of a contact has the share of the first.
      const bool is_second = rows[i].normal >= 0 && i > 0 && rows[i - 1].normal == rows[i].normal;
      const double now = is_second ? share[i - 1] : shareOf(rows, i, spring);
      change = std::max(change, std::abs(now - share[i]));
      share[i] = now;
    }
    if (change < kSettled) break;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SoftRow& row = rows[i];
    const double free = row.bend + dt_s * row.direction.dot(v);
    row.bend_new = share[i] < 1 && !row.only_pushes && row.stiffness > 0 ? -row.force / row.stiffness : free;
  }
  return v;
}

}  // namespace darwinop::gap
