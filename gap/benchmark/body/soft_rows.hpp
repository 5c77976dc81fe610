// One time step of coupled joints with dry friction and contacts as bounded springs and dampers, implicit in all of
// them. Another method than the solver of gap/plant/body, which makes contacts and friction constraints.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace darwinop::gap {

/// A spring and damper along one generalized direction, whose force is limited.
struct SoftRow {
  Eigen::VectorXd direction;  // velocity of the row = direction . v
  double stiffness = 0, damping = 0;
  double bend = 0;   // of the spring at the start of the step
  double limit = 0;  // greatest force either way; of a contact's sideways rows: see `normal`
  int normal = -1;   // index of the row whose force times `limit` bounds this row and the next one together
  bool only_pushes = false;

  double force = 0;     // solved
  double bend_new = 0;  // after the step; where the limit has acted, what the force at the limit would bend
};

/// Velocities after a step of `dt_s`: (M + dt D) v = M v0 + dt force + J' (forces of the rows). `damping`: diagonal.
Eigen::VectorXd stepped(const Eigen::MatrixXd& mass, const Eigen::VectorXd& damping, const Eigen::VectorXd& velocity,
                        const Eigen::VectorXd& force, double dt_s, std::vector<SoftRow>& rows);

}  // namespace darwinop::gap
