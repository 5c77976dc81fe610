// The robot that an answer describes: effects of a result, read back by the catalogues that named them.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "gap/localize/body/floor_residuals.hpp"

namespace darwinop::gap {

struct AnsweredRobot {
  FloorModel model;
  double battery_ohm = 0;
};

/// A model without any effect of an answer.
AnsweredRobot unchangedRobot(const twin::Model& model);

/// Joints of "at": a name, a list of names, or "all". Throws std::runtime_error for a joint that does not exist.
std::vector<Joint> jointsAt(const nlohmann::json& at);

/// Adds one effect of an answer: {"id", "at", "params"}. Parameters that it does not have are neutral. Throws
/// std::runtime_error, a sentence, for an effect, a place or a parameter that does not exist.
void addEffect(AnsweredRobot& robot, const nlohmann::json& effect, const twin::Model& model);

}  // namespace darwinop::gap
