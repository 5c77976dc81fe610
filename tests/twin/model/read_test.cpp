// Reading and writing of model files.
#include <gtest/gtest.h>

#include <cmath>

#include "twin/effects/catalogue.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

TEST(ModelFile, ValuesAreStoredUnderTheirKey) {
  const Model model = modelOf(
      "[servo]\nlaw = speed_p\nkt = 1.5 N m/A\narmature = 2e-3 kg m2\naccel_max = 55 rad/s2\n"
      "[body]\nxml = bodies/robot.xml\ntrunk_com = halfway\ntrunk_inertia = published\nself_collision = "
      "yes\nhold_until_driven = yes\n"
      "step = 0.0005 s\n"
      "[imu]\ngyro_bias = 0.01, 0, -0.02 rad/s\naccel_scale = 1, -1, 1\n");
  EXPECT_EQ(model.name, "test");
  EXPECT_EQ(model.servo.law, Law::kSpeedP);
  EXPECT_EQ(model.servo.kt_nm_a, 1.5);
  EXPECT_EQ(model.servo.armature_kgm2, 0.002);
  EXPECT_EQ(model.servo.accel_max_rad_s2, 55);
  EXPECT_EQ(model.body.xml, "bodies/robot.xml");
  EXPECT_EQ(model.body.trunk_com, TrunkCom::kHalfway);
  EXPECT_EQ(model.body.trunk_inertia, TrunkInertia::kPublished);
  EXPECT_TRUE(model.body.self_collision);
  EXPECT_TRUE(model.body.hold_until_driven);
  EXPECT_EQ(model.body.step_s, 0.0005);
  EXPECT_EQ(model.imu.gyro_bias_rad_s, (std::array<double, 3>{0.01, 0, -0.02}));
  EXPECT_EQ(model.imu.accel_scale, (std::array<double, 3>{1, -1, 1}));
}

TEST(ModelFile, AbsentKeysHaveTheirDefault) {
  const Model model = modelOf("[servo]\nkt = 1.5 N m/A\n");
  EXPECT_EQ(model.servo.resistance_ohm, ServoParameters{}.resistance_ohm);
  EXPECT_EQ(model.body.trunk_com, BodySettings{}.trunk_com);
  EXPECT_TRUE(model.effects.empty());
}

TEST(ModelFile, NoneMeansNoLimit) {
  EXPECT_TRUE(std::isinf(modelOf("[servo]\naccel_max = none\n").servo.accel_max_rad_s2));
  EXPECT_TRUE(std::isinf(modelOf("[servo]\noverload_time = none\n").servo.overload_time_s));
}

TEST(ModelFile, AcceptsTheCommonIniSyntax) {
  const Model model = parseModel(
      "\xEF\xBB\xBF; made on another system\r\n[Model]\r\n  Name : test ; comment\r\n\r\n"
      "[SERVO]\r\nKT=1.5N m/A\r\nsupply = +11.1\tV # three cells\r\nback_emf = 2   V  s/rad\r\n"
      "[Effect COULOMB neck]\r\nFriction = 0.05 N m",
      "my.ini");
  EXPECT_EQ(model.name, "test");
  EXPECT_EQ(model.servo.kt_nm_a, 1.5);
  EXPECT_EQ(model.servo.supply_v, 11.1);
  EXPECT_EQ(model.servo.back_emf_vs_rad, 2);
  ASSERT_EQ(model.effects.size(), 1U);
  EXPECT_EQ(model.effects[0].info, findEffect("coulomb"));
  EXPECT_EQ(model.effects[0].joint, Joint::kNeck);
  EXPECT_EQ(model.effects[0].values, std::vector<double>{0.05});
}

TEST(ModelFile, TheFolderIsTheOneOfTheFile) {
  EXPECT_EQ(parseModel(kNamed + "[body]\nxml = own.xml\n", "/some/where/my.ini").folder, "/some/where");
}

TEST(WriteModel, RefusesValuesThatCannotBeReadBack) {
  Model model;
  EXPECT_EQ(
      refusal([&] { writeModel(model); }),
      "the model to be written, line 2: [model] name = : give a text of 1 to 120 characters without quotes, ; and "
      "#");
  for (const char* name : {"a;b", "a#b", "\"a\"", "a ", " a"}) {
    model.name = name;
    EXPECT_EQ(refusal([&] { writeModel(model); }), messages::kUnwritableText) << name;
  }
  model.name = "test";
  model.servo.kt_nm_a = -1;
  EXPECT_EQ(refusal([&] { writeModel(model); }),
            std::string{"the model to be written, line 8: [servo] kt = -1 N m/A: "} + messages::kOutOfRange +
                "0.01 to 10 N m/A");
}

}  // namespace
}  // namespace darwinop::twin
