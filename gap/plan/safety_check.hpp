// Checks that an experiment is safe for the servo under every hypothesis.
#pragma once

#include <string>
#include <vector>

#include "gap/plan/experiment_candidate.hpp"
#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

struct Vetted {
  ExperimentCandidate candidate;  // what may be run
  std::vector<std::string> cuts;  // sentences: what was taken away, and why
  std::string refused;            // why it must not be run at all; empty: it may
  double seconds = 0;             // of robot time, way there and back and preparation included; at most
};

/// Checks the plan as `darwinop experiment run` does, then runs it under every hypothesis: the joint must stay within
/// its limits, no faster than its register counts, and not at its greatest duty for long. Rounds that would not are
/// left out, and what only holds is cut short.
Vetted vetted(ExperimentCandidate candidate, const ArmSetup& stand, const Case& given,
              const std::vector<Hypothesis>& hypotheses);

}  // namespace darwinop::gap
