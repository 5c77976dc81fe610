// The models that are shipped are sound, and say what data sheet and thesis say.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/units.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

Model shipped(const std::string& name) {
  return readModel(DARWINOP_SHIPPED_MODELS "/" + name + ".ini");
}

double valueOf(const Model& model, std::string_view effect) {
  for (const EffectSetting& setting : model.effects)
    if (setting.info->id == effect && !setting.joint) return setting.values.at(0);
  ADD_FAILURE() << model.name << " has no " << effect;
  return NAN;
}

TEST(ShippedModels, AreAllSoundAndCalledAsTheirFiles) {
  int models = 0;
  for (const auto& entry : std::filesystem::directory_iterator{DARWINOP_SHIPPED_MODELS}) {
    if (entry.path().extension() != ".ini") continue;
    EXPECT_EQ(readModel(entry.path()).name, entry.path().stem()) << entry.path();
    ++models;
  }
  EXPECT_GE(models, 2);
}

// Data sheet of the MX-28 at 12 V: 55 rpm without load. Four digits of the file are worth 0.02 rpm.
TEST(ShippedModels, TheServoTurnsAsFastAsItsDataSheetSays) {
  const Model model = shipped("darwin-op");
  const ServoParameters& s = model.servo;
  const double free_torque_nm = s.kt_nm_a * s.supply_v * s.duty_max / s.resistance_ohm - valueOf(model, "coulomb");
  const double braking_nms_rad = s.kt_nm_a * s.back_emf_vs_rad / s.resistance_ohm + valueOf(model, "viscous");
  EXPECT_NEAR(free_torque_nm / braking_nms_rad * 60 / (2 * kPi), 55, 0.05);
}

// Data sheet of the MX-28 at 12 V: 2.5 N m and 1.4 A when it stands.
TEST(ShippedModels, TheServoStandsStillAtTheTorqueOfItsDataSheet) {
  const ServoParameters s = shipped("darwin-op").servo;
  EXPECT_EQ(s.law, Law::kVoltageP);
  EXPECT_NEAR(s.supply_v / s.resistance_ohm, 1.4, 0.001);
  EXPECT_NEAR(s.kt_nm_a * s.supply_v / s.resistance_ohm, 2.5, 0.002);
}

TEST(ShippedModels, TheSimulatorOf2013IsThatOf2013) {
  const Model model = shipped("webots-2013");
  EXPECT_EQ(model.servo.law, Law::kSpeedP);
  EXPECT_EQ(model.servo.speed_gain_per_kp_1_s * 8, 1);  // P = register / 8
  EXPECT_EQ(model.servo.speed_max_rad_s, 12.26);
  EXPECT_EQ(model.servo.accel_max_rad_s2, 55);
  EXPECT_EQ(model.servo.torque_max_nm, 2.5);
  EXPECT_EQ(valueOf(model, "coulomb"), 0.025);
  EXPECT_EQ(valueOf(model, "viscous"), 0.002);
  EXPECT_EQ(model.body.trunk_com, TrunkCom::kWebots2013);
  EXPECT_EQ(model.body.trunk_inertia, TrunkInertia::kPublished);
}

}  // namespace
}  // namespace darwinop::twin
