// A model written for another simulator, with a list of what is lost.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "gap/export/numbers.hpp"
#include "gap/export/target.hpp"

namespace darwinop::gap {

struct ExportSettings {
  std::string joint = "joint";                    // letters, digits, '_' and '-'
  std::string model = "a model of darwinop gap";  // named in the comments
  double p_register = 32;
  double temperature_c = twin::kRoomC;
  double payload_kg = 0;  // of the link that is written with the joint: an arm as of a bench
  double step_s = std::numeric_limits<double>::quiet_NaN();  // of the target; NaN: its usual one

  [[nodiscard]] Conditions conditions() const { return {.p_register = p_register, .temperature_c = temperature_c}; }
  [[nodiscard]] double stepOf(Target target) const { return step_s > 0 ? step_s : infoOf(target).step_s; }
};

struct Export {
  std::string text;                       // a file of one joint and its link, with comments of units and origin
  std::vector<std::string> lost;          // a sentence each
  std::vector<std::string> approximated;  // likewise
};

/// Throws std::runtime_error for a name that the target could not read, and for an impossible P gain or step.
void checkSettings(Target target, const ExportSettings& settings);
/// A sentence for what the target does not hold.
void addLoss(Target target, const std::string& what, const twin::Holding& holding, Export& out);

/// Throws as checkSettings().
Export exportTo(Target target, const Hypothesis& hypothesis, const ExportSettings& settings);

}  // namespace darwinop::gap
