// Two rows have nine cases: each force free, or at one of its bounds. Exact, where sweeps creep when a light gear meets
// a heavy arm.
#include "gap/export/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace darwinop::gap {
namespace {

struct Rows {
  std::array<std::array<double, 2>, 2> a{};  // what each row's motion makes of each force
  std::array<double, 2> missing{};           // motion that each row lacks
  std::array<Constraint, 2> c{};
  std::size_t count = 0;

  [[nodiscard]] double violation(const std::array<double, 2>& f, const std::array<int, 2>& state) const {
    double worst = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double left = a[i][0] * f[0] + a[i][1] * f[1] - missing[i];
      if (state[i] == 0)  // also in units of motion
        worst = std::max(worst, a[i][i] * std::max(f[i] - c[i].high, c[i].low - f[i]));
      else
        worst = std::max(worst, state[i] < 0 ? -left : left);
    }
    return worst;
  }

  [[nodiscard]] std::array<double, 2> forces(const std::array<int, 2>& state) const {
    std::array<double, 2> f{};
    for (std::size_t i = 0; i < count; ++i)
      if (state[i] != 0) f[i] = state[i] < 0 ? c[i].low : c[i].high;
    const bool both = count == 2 && state[0] == 0 && state[1] == 0;
    if (both) {
      const double det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
      return {(missing[0] * a[1][1] - missing[1] * a[0][1]) / det, (missing[1] * a[0][0] - missing[0] * a[1][0]) / det};
    }
    for (std::size_t i = 0; i < count; ++i)
      if (state[i] == 0) f[i] = (missing[i] - a[i][1 - i] * f[1 - i]) / a[i][i];
    return f;
  }
};

}  // namespace

std::array<double, 2> solveConstraints(std::span<const Constraint> constraints, const Pair& mobility,
                                       const Pair& free) {
  Rows rows;
  rows.count = std::min<std::size_t>(2, constraints.size());
  for (std::size_t i = 0; i < rows.count; ++i) {
    const Constraint& c = rows.c[i] = constraints[i];
    for (std::size_t j = 0; j < rows.count; ++j)
      rows.a[i][j] = c.direction.gear * mobility.gear * constraints[j].direction.gear +
                     c.direction.arm * mobility.arm * constraints[j].direction.arm;
    rows.a[i][i] += c.softness;
    rows.missing[i] = c.wanted - c.direction.gear * free.gear - c.direction.arm * free.arm;
  }
  std::array<double, 2> best{};
  double least = std::numeric_limits<double>::infinity();
  for (const int first : {0, -1, 1})
    for (const int second : {0, -1, 1}) {
      if (rows.count < 2 && second != 0) continue;
      const std::array<int, 2> state{first, second};
      const std::array<double, 2> f = rows.forces(state);
      const double off = rows.violation(f, state);
      if (std::isfinite(f[0]) && std::isfinite(f[1]) && off < least) {
        least = off;
        best = f;
      }
    }
  return best;
}

}  // namespace darwinop::gap
