#include "gap/identify/body/compared_models.hpp"

#include <cmath>
#include <stdexcept>

#include "gap/identify/body/held_out_text.hpp"

namespace darwinop::gap {
namespace {

/// `before` and `after` are both of this model.
HeldOutGap gapOf(BodyCase given, const twin::Model& model) {
  given.joints.model = model;
  const FloorModel declared{.robot = {.robot = declaredRobot(given), .floor = {}}};
  return heldOutGap(given, declared, declared);
}

}  // namespace

HeldOutGap compareModels(const BodyCase& given, const twin::Model& before, const twin::Model& after) {
  const HeldOutGap old = gapOf(given, before), now = gapOf(given, after);
  for (const GapErrors& of : {old.before, now.after})
    if (std::isfinite(of.joints) || std::isfinite(of.gyro) || std::isfinite(of.accel))
      return {old.before, now.after, now.floor};
  throw std::runtime_error(given.folder + messages::kNothingHeldOut);
}

std::string comparedText(const BodyCase& given, const HeldOutGap& gap) {
  return given.name + ", before -> after:\n" + asText(gap);
}

nlohmann::ordered_json comparedJson(const BodyCase& given, const HeldOutGap& gap) {
  return {{"case", given.name},
          {"gap_score_before", asJson(gap.before)},
          {"gap_score_after", asJson(gap.after)},
          {"floor", asJson(gap.floor)}};
}

}  // namespace darwinop::gap
