// Ranks recordings of the whole robot by what they would separate, per minute of robot time.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gap/plan/body/planned_motion.hpp"
#include "gap/plan/body/predicted_signals.hpp"
#include "gap/plan/body/rival_models.hpp"

namespace darwinop::gap {

struct RankedMotion {
  PlannedMotion motion;
  /// Of each pair of rivals (0-1, 0-2, 1-2), or of the first model and each other.
  std::vector<SignalDifference> differences;
  double gain = 0;  // expected difference of log likelihood
  [[nodiscard]] double perMinute() const { return gain / (motion.seconds / 60); }
};

struct BodyPlan {
  BodyQuestion question;
  std::vector<RankedMotion> ranked;   // best first
  std::vector<std::string> left_out;  // names of motions on the floor: no recording of the runtime there is simulated
};

/// Simulates each motion under each model. Rivals: the nearest pair counts. Effects that would show: their sum, without
/// those that the recordings of the case show already, which leave the question. A difference beyond that which is
/// certain to show adds nothing. Motions on the floor only where the case has recordings there that are simulated.
BodyPlan nextMotions(const BodyCase& given, BodyQuestion question, std::vector<PlannedMotion> motions);

/// For a terminal; for programs. `folder`: of the case, as a word for a shell.
std::string asText(const BodyPlan& plan, const std::string& folder);
nlohmann::ordered_json asJson(const BodyPlan& plan, const std::string& folder);

}  // namespace darwinop::gap
