// How strong an effect has to be to open a gap of some size. Determined by simulation on the bench of the case.
#pragma once

#include "core/random.hpp"
#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

inline constexpr double kFloor = 0.001;  // rad: rms position error of a right model on such logs

/// Rms position error over the logs for fitting that a severity means: 1 about 2 to 4 floors, 2 about 10 to 30, 3 more.
struct GapRange {
  double low_rad, high_rad;
};
GapRange gapRangeOf(int severity);
/// 0: below what a log shows.
int severityOfGap(double gap_rad);

/// Rms difference of the positions of the two, over all logs for fitting, without noise.
double gapBetween(const Case& given, const Hypothesis& a, const Hypothesis& b);

struct Strength {
  int severity = 0;            // as requested, or what the plausible range or a prior permits on this bench
  std::vector<double> values;  // of all parameters; includes what the baseline has already (friction)
  double gap_rad = 0;
};
/// The values of `effect` that open a gap of this severity beside the bench `without`. `rng` draws the direction
/// (lighter or heavier) and what else the effect leaves open. Deterministic. The commands of `given` are enough.
Strength strengthOf(const Case& given, const Hypothesis& without, const twin::EffectInfo& effect, int severity,
                    Rng& rng);

}  // namespace darwinop::gap
