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
  std::vector<RankedMotion> ranked;  // best first
};

/// Simulates each motion under each model. Rivals: the nearest pair counts. Effects that would show: their sum, without
/// those that the recordings of the case show already, which leave the question. A difference beyond that which is
/// certain to show adds nothing.
BodyPlan nextMotions(const BodyCase& given, BodyQuestion question, std::vector<PlannedMotion> motions);

/// For a terminal; for programs.
std::string asText(const BodyPlan& plan);
nlohmann::ordered_json asJson(const BodyPlan& plan);

}  // namespace darwinop::gap
