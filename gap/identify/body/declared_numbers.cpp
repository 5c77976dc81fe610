#include "gap/identify/body/declared_numbers.hpp"

#include <limits>

#include "gap/identify/body/mechanics_fit.hpp"

namespace darwinop::gap {
namespace {

double priorCostAt(const ClampedRobot& robot, const PlacedMechanics& effect, Joint joint) {
  double sum = 0;
  bool is_declared = false;
  for (const BodyNuisance& number : nuisancesOf(robot.given(), robot.limbs()[robot.limbOf(joint)])) {
    if (number.effect != effect.effect->id || number.at != joint) continue;
    const double sigmas = number.sigmas_of(effect.values);
    sum += sigmas * sigmas;
    is_declared = true;
  }
  return is_declared ? sum : std::numeric_limits<double>::infinity();
}

}  // namespace

double priorCost(const ClampedRobot& robot, const PlacedMechanics& effect) {
  double sum = 0;
  for (const Joint joint : effect.joints) sum += priorCostAt(robot, effect, joint);
  return sum;
}

void moveNumbers(ClampedRobot& robot, const PlacedMechanics& effect, const BodyHypothesis& about) {
  for (const std::size_t limb : limbsOf(robot, {effect}))
    robot.replace(limb, robot.residuals(limb).withNumbersOf(effect.effect->id, effect.joints, effect.values, about));
}

}  // namespace darwinop::gap
