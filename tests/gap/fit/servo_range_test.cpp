// Search ranges in proportion to the servo.
#include "gap/fit/servo_range.hpp"

#include <gtest/gtest.h>

#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

TEST(SearchRange, OfFrictionGrowsWithTheServo) {
  twin::ServoParameters strong;
  strong.kt_nm_a *= 4;
  const auto high = [](std::string_view id, const twin::ServoParameters& servo) {
    return unknownsOf(*twin::findEffect(id), servo).front().high;
  };
  EXPECT_DOUBLE_EQ(high("coulomb", {}), unknownsOf(*twin::findEffect("coulomb")).front().high);
  EXPECT_DOUBLE_EQ(high("coulomb", strong), 4 * high("coulomb", {}));
  EXPECT_DOUBLE_EQ(high("quadratic_load_friction", strong), high("quadratic_load_friction", {}) / 4);
  EXPECT_DOUBLE_EQ(high("load_dependent_friction", strong), high("load_dependent_friction", {}));
}

TEST(SearchRange, OfAnArmatureGrowsWithIt) {
  twin::ServoParameters large;
  large.armature_kgm2 *= 10;
  const Unknown usual = unknownsOf(*twin::findEffect("inertia"), twin::ServoParameters{}).front(),
                wide = unknownsOf(*twin::findEffect("inertia"), large).front();
  EXPECT_DOUBLE_EQ(usual.low, unknownsOf(*twin::findEffect("inertia")).front().low);
  EXPECT_DOUBLE_EQ(wide.low, 10 * usual.low);
  EXPECT_DOUBLE_EQ(wide.high, 10 * usual.high);
  large.armature_kgm2 = 0;
  EXPECT_DOUBLE_EQ(unknownsOf(*twin::findEffect("inertia"), large).front().high, usual.high);
}

/// A fitted number that a model file refuses would end a run without an answer.
TEST(SearchRange, IsWithinWhatAModelFileMayHold) {
  for (const double size : {0.1, 1.0, 6.0, 20.0}) {
    twin::ServoParameters servo;
    servo.kt_nm_a *= size, servo.armature_kgm2 *= size;
    for (const twin::EffectInfo* const info : twin::catalogue())
      for (const Unknown& unknown : unknownsOf(*info, servo)) {
        const auto& parameter = std::get<EffectParameter>(unknown.what);
        const twin::NumberRule allowed = twin::ruleOf(info->parameters[parameter.index]);
        EXPECT_GE(unknown.low, allowed.low) << info->id << " " << size;
        EXPECT_LE(unknown.high, allowed.high) << info->id << " " << size;
        EXPECT_LE(unknown.low, unknown.expected) << info->id << " " << size;
        EXPECT_LE(unknown.expected, unknown.high) << info->id << " " << size;
      }
  }
}

}  // namespace
}  // namespace darwinop::gap
