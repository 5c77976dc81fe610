// Synthetic cases: logs simulated with effects that the case's model does not have.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gap/benchmark/make/answer_key.hpp"
#include "gap/benchmark/make/case_plan.hpp"
#include "gap/plant/bench/roll_out.hpp"

namespace darwinop::gap {

struct HiddenEffect {
  std::string id;                             // of the catalogue, or of outside.hpp
  std::map<std::string, double> values = {};  // by key; friction comes on top of the baseline's. Others are neutral
  int severity = 0;  // without values: 1 to 3, what opens such a gap; 0 is typical. An outside effect is drawn
};

struct CaseRequest {
  std::string name = "hidden";  // of the case; must not reveal the effect
  std::uint64_t seed = 1;       // of everything that is drawn
  Baseline baseline = Baseline::kFriction;
  std::optional<Case> like;    // bench, priors and commands of this case; nothing: they are drawn
  bool wrong_numbers = false;  // of the baseline, by up to one sigma of their priors
  std::vector<HiddenEffect> effects;
  Disturbance disturbance;  // its seed does not matter
};

struct Hidden {
  Case given;
  Key key;
};

/// The case in memory. The same for the same request. Throws std::runtime_error, a sentence, for an effect or a
/// parameter that does not exist, or a value outside its range.
Hidden hidden(const CaseRequest& request);

/// Writes FOLDER/cases/NAME and adds to FOLDER/key.json.
void hide(const CaseRequest& request, const std::string& folder);

}  // namespace darwinop::gap
