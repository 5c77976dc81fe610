#include "gap/plant/row_state.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include "gap/thresholds.hpp"

namespace darwinop::gap {

RowState stateAt(const Trajectory& log, std::size_t row) {
  const double half = thresholds::kStateHalfWindow;
  std::size_t from = row, to = row;
  while (from > 0 && log.time_s[row] - log.time_s[from - 1] <= half) --from;
  while (to + 1 < log.rows() && log.time_s[to + 1] - log.time_s[row] <= half) ++to;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = from; i <= to; ++i) {
    const double t = (log.time_s[i] - log.time_s[row]) / half;
    const Eigen::Vector3d basis{1, t, t * t};
    normal += basis * basis.transpose();
    right += basis * (log.position_rad[i] - log.position_rad[row]);
  }
  normal.diagonal().array() += 1e-9;  // fewer than three rows: still solvable
  const Eigen::Vector3d fit = normal.inverse() * right;
  return {log.position_rad[row] + fit[0], fit[1] / half};
}

}  // namespace darwinop::gap
