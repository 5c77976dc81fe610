// Error messages of invalid model files: file, line, key, allowed values.
#include <gmock/gmock.h>

#include "twin/model/keys.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Wrong {
  std::string lines, sentence;
};
void PrintTo(const Wrong& wrong, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << wrong.lines;
}

class WrongModelFile : public testing::TestWithParam<Wrong> {};

TEST_P(WrongModelFile, IsRefusedWithFileLineKeyAndAllowedValues) {
  EXPECT_EQ(refusalOf(GetParam().lines), "my.ini, line " + GetParam().sentence);
}

INSTANTIATE_TEST_SUITE_P(
    Sections, WrongModelFile,
    testing::Values(Wrong{"[servos]\n", "3: there is no section [servos]; did you mean [servo]?"},
                    Wrong{"[camera]\n",
                          "3: there is no section [camera]; there are [model], [servo], [body], [imu], "
                          "[link NAME] and [effect NAME]"},
                    Wrong{"[]\n",
                          "3: there is no section []; there are [model], [servo], [body], [imu], [link NAME] "
                          "and [effect NAME]"},
                    Wrong{"[Robot]\n",
                          "3: there is no section [Robot]; this is a robot's settings file (docs/robot-file.md), not a "
                          "model"},
                    Wrong{"[coulomb]\n", "3: there is no section [coulomb]; write an effect as [effect coulomb]"},
                    Wrong{"[servo\n", "3: the section's closing bracket ] is missing"},
                    Wrong{"[servo] kt\n", "3: there is something behind the section's closing bracket ]"},
                    Wrong{"[servo]\n\n[body]\n[Servo]\n", "6: [servo] is already in line 3; keep one of the two"},
                    Wrong{"[servo]\nkt 1.5 N m/A\n",
                          "4: \"kt 1.5 N m/A\" is neither a [section], nor key = value, nor a comment"}));

INSTANTIATE_TEST_SUITE_P(
    Keys, WrongModelFile,
    testing::Values(
        Wrong{"[servo]\nresistence = 8 ohm\n", "4: [servo] resistence = 8 ohm: no such key; did you mean resistance?"},
        Wrong{"[body]\nmass = 3 kg\n",
              "4: [body] mass = 3 kg: no such key; there are xml, trunk_com, trunk_inertia, "
              "self_collision, hold_until_driven, "
              "floor_friction, contact_time, sole_size, floor_tilt_x, floor_tilt_y, battery_resistance and step"},
        Wrong{"[imu]\ngyro_axes = 1, -1, 3\n",
              "4: [imu] gyro_axes reads no three axes; give 1, 2 and 3 in any order, with or without minus"},
        Wrong{"[link ArmLowerR]\nmas = 3 kg\n", "4: [link ArmLowerR] mas = 3 kg: no such key; did you mean mass?"},
        Wrong{"[link armlowerr]\nmass = 9 kg\n", "4: [link ArmLowerR] mass = 9 kg: out of range; give -5 to 5 kg"},
        Wrong{"[link ArmLowerR]\nmass = 0.1 kg\n[link armlowerr]\n",
              "5: [link ArmLowerR] is already in line 3; keep one of the two"},
        Wrong{"[servo]\nkt = 1 N m/A\n;\nKT = 2 N m/A\n", "6: [servo] KT is already in line 4; keep one of the two"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, WrongModelFile,
    testing::Values(
        Wrong{"[servo]\nkt = +-5 N m/A\n", "4: [servo] kt = +-5 N m/A: not a number; give 0.01 to 10 N m/A"},
        Wrong{"[servo]\nkt = 1e999 N m/A\n",
              std::string{"4: [servo] kt = 1e999 N m/A: "} + messages::kOutOfRange + "0.01 to 10 N m/A"},
        Wrong{"[servo]\nkt = 1 N\xc2\xb7m/A\n",
              "4: [servo] kt = 1 N\xc2\xb7m/A: the unit is N m/A, not N\xc2\xb7m/A; write 1 N m/A"},
        Wrong{"[servo]\nkt = 1.786\n", "4: [servo] kt = 1.786: the unit is missing; write 1.786 N m/A"},
        Wrong{"[servo]\nkt = 1.786 Nm/A\n",
              "4: [servo] kt = 1.786 Nm/A: the unit is N m/A, not Nm/A; write 1.786 N m/A"},
        Wrong{"[servo]\nkt = 1.786 V\n", "4: [servo] kt = 1.786 V: the unit is N m/A, not V; give 0.01 to 10 N m/A"},
        Wrong{"[servo]\nspeed_max = 55 rpm\n",
              "4: [servo] speed_max = 55 rpm: the unit is rad/s, not rpm; write 5.75959 rad/s"},
        Wrong{"[imu]\ngyro_range = 1600 deg/s\n",
              "4: [imu] gyro_range = 1600 deg/s: the unit is rad/s, not deg/s; write 27.9253 rad/s"},
        Wrong{"[effect backlash]\nplay = 0.5 degrees\n",
              "4: [effect backlash] play = 0.5 degrees: the unit is rad, not degrees; write 0.00872665 rad"},
        Wrong{"[effect backlash]\nplay = 0.5°\n",
              "4: [effect backlash] play = 0.5°: the unit is rad, not °; write 0.00872665 rad"},
        Wrong{"[body]\nstep = 1 ms\n", "4: [body] step = 1 ms: the unit is s, not ms; write 0.001 s"},
        Wrong{"[imu]\naccel_range = 4 g\n", "4: [imu] accel_range = 4 g: the unit is m/s2, not g; write 39.2266 m/s2"},
        Wrong{"[servo]\nduty_max = 90 %\n",
              "4: [servo] duty_max = 90 %: this is a pure number, without the unit %; write 0.9"},
        Wrong{"[servo]\nduty_max = 1 V\n",
              "4: [servo] duty_max = 1 V: this is a pure number, without the unit V; give 0.01 to 1"},
        Wrong{"[servo]\nkt = much\n", "4: [servo] kt = much: not a number; give 0.01 to 10 N m/A"},
        Wrong{"[servo]\nkt =\n", "4: [servo] kt = : not a number; give 0.01 to 10 N m/A"},
        Wrong{"[servo]\nkt = 1,786 N m/A\n",
              "4: [servo] kt = 1,786 N m/A: not a number; give 0.01 to 10 N m/A, with a point for decimals"},
        Wrong{"[servo]\nkt = 1.7.8 N m/A\n", "4: [servo] kt = 1.7.8 N m/A: not a number; give 0.01 to 10 N m/A"},
        Wrong{"[servo]\nkt = nan N m/A\n", "4: [servo] kt = nan N m/A: not a finite number; give 0.01 to 10 N m/A"},
        Wrong{"[servo]\naccel_max = inf rad/s2\n",
              "4: [servo] accel_max = inf rad/s2: not a finite number; give 0.1 to 100000 rad/s2, or none for no "
              "limit"},
        Wrong{"[servo]\nkt = none\n", "4: [servo] kt = none: none is not allowed here; give 0.01 to 10 N m/A"},
        Wrong{"[servo]\nkt = 1786 N m/A\n",
              std::string{"4: [servo] kt = 1786 N m/A: "} + messages::kOutOfRange + "0.01 to 10 N m/A"},
        Wrong{"[servo]\narmature = -0.001 kg m2\n",
              std::string{"4: [servo] armature = -0.001 kg m2: "} + messages::kOutOfRange + "0 to 1 kg m2"}));

INSTANTIATE_TEST_SUITE_P(
    WordsTextsAndAxes, WrongModelFile,
    testing::Values(
        Wrong{"[servo]\nlaw = torque_p\n", "4: [servo] law = torque_p: give voltage_p or speed_p"},
        Wrong{"[body]\ntrunk_com = mine\n", "4: [body] trunk_com = mine: give manufacturer, webots-2013 or halfway"},
        Wrong{"[body]\nself_collision = maybe\n", "4: [body] self_collision = maybe: give no or yes"},
        Wrong{"[body]\nxml =\n", "4: [body] xml = : give a text of 1 to 120 characters without quotes, ; and #"},
        Wrong{"[imu]\ngyro_bias = 0.1 rad/s\n",
              "4: [imu] gyro_bias = 0.1 rad/s: give three numbers, for the axes x, y and z, as in -1, 0, 1 rad/s"},
        Wrong{"[imu]\ngyro_bias = 0, 0, 0, 0 rad/s\n",
              "4: [imu] gyro_bias = 0, 0, 0, 0 rad/s: give three numbers, for the axes x, y and z, as in -1, 0, 1 "
              "rad/s"},
        Wrong{"[imu]\ngyro_bias = 0 rad/s, 0 rad/s, 0 rad/s\n",
              "4: [imu] gyro_bias = 0 rad/s, 0 rad/s, 0 rad/s: give three numbers, for the axes x, y and z, as in "
              "-1, 0, 1 rad/s"},
        Wrong{"[imu]\ngyro_bias = 0, 0, 0.1\n", "4: [imu] gyro_bias = 0, 0, 0.1: the unit is missing; write 0.1 rad/s"},
        Wrong{"[imu]\ngyro_bias = 0, 5, 0 rad/s\n",
              std::string{"4: [imu] gyro_bias = 0, 5, 0 rad/s: "} + messages::kOutOfRange + "-1 to 1 rad/s"}));

INSTANTIATE_TEST_SUITE_P(
    Effects, WrongModelFile,
    testing::Values(Wrong{"[effect culomb]\n", "3: there is no effect \"culomb\"; did you mean coulomb?"},
                    Wrong{"[effect]\n", std::string{"3: [effect]: "} + messages::kEffectSyntax},
                    Wrong{"[effect coulomb Nek]\n", "3: there is no joint \"Nek\"; did you mean Neck?"},
                    Wrong{"[effect coulomb Neck Head]\n",
                          std::string{"3: [effect coulomb Neck Head]: "} + messages::kEffectSyntax},
                    Wrong{"[effect coulomb]\n\n[body]\n",
                          std::string{"3: [effect coulomb] friction"} + messages::kMissing + "0 to 4 N m"},
                    Wrong{"[effect coulomb Neck]\nfriktion = 0.1 N m\n",
                          "4: [effect coulomb Neck] friktion = 0.1 N m: no such key; did you mean friction?"},
                    Wrong{"[effect coulomb]\nfriction = 25 mN m\n",
                          "4: [effect coulomb] friction = 25 mN m: the unit is N m, not mN m; write 0.025 N m"},
                    Wrong{"[effect coulomb]\nfriction = 5 N m\n",
                          std::string{"4: [effect coulomb] friction = 5 N m: "} + messages::kOutOfRange + "0 to 4 N m"},
                    Wrong{"[effect coulomb Neck]\nfriction = 0.1 N m\n[effect coulomb neck]\nfriction = 0.2 N m\n",
                          "5: [effect coulomb Neck] is already in line 3; keep one of the two"}));

TEST(WrongModelFileAsAWhole, AnEffectThatItsLawCannotShowIsRefused) {
  const std::string speed = "[servo]\nlaw = speed_p\n", integral = "[effect integral]\ngain = 20 1/s\n";
  EXPECT_EQ(refusalOf(speed + integral), std::string{"my.ini, line 6: [effect integral] gain"} + messages::kNoEquation +
                                             "remove the section, or choose the law voltage_p in [servo]");
  EXPECT_EQ(refusalOf(speed + "[effect deadband Neck]\nwidth = 0.01 rad\npunch = 0.05\n"),
            std::string{"my.ini, line 7: [effect deadband Neck] punch"} + messages::kNoEquation +
                "give punch = 0, or choose the law voltage_p in [servo]");
  EXPECT_EQ(refusalOf(integral + speed + "[effect p_on_torque]\non = 0\n").substr(0, 14), "my.ini, line 4");
  for (const std::string& lines :
       {integral, speed + "[effect integral]\ngain = 0 1/s\n", speed + integral + "[effect p_on_torque]\non = 1\n",
        speed + integral + "[effect p_on_torque Neck]\non = 1\n"})
    EXPECT_EQ(refusalOf(lines), "") << lines;
}

TEST(WrongModelFileAsAWhole, NeedsAName) {
  EXPECT_EQ(refusal([] { parseModel("; only this\n", "my.ini"); }),
            "my.ini, line 1: [model] name is missing; add one, as in name = my-robot");
  EXPECT_EQ(refusal([] { parseModel("\n[model]\n", "my.ini"); }),
            "my.ini, line 2: [model] name is missing; add one, as in name = my-robot");
}

TEST(WrongModelFileAsAWhole, HasNothingBeforeItsFirstSection) {
  EXPECT_EQ(refusal([] { parseModel("name = test\n", "my.ini"); }),
            "my.ini, line 1: key \"name\" is before the first section; start the file with [model]");
}

TEST(WrongModelFileAsAWhole, NeedsAContactTimeOfAtLeastTwoSteps) {
  EXPECT_EQ(refusalOf("[body]\nstep = 0.005 s\ncontact_time = 0.008 s\n"),
            "my.ini, line 5: [body] contact_time is shorter than two steps; give at least 0.01 s, or a smaller step");
  EXPECT_EQ(refusalOf("[body]\nstep = 0.005 s\n"),
            "my.ini, line 4: [body] contact_time is shorter than two steps; give at least 0.01 s, or a smaller step");
}

TEST(WrongModelFileAsAWhole, AnUnknownEffectFarFromAllNamesGetsTheList) {
  EXPECT_THAT(refusalOf("[effect zzzzzz]\n"), StartsWith("my.ini, line 3: there is no effect \"zzzzzz\"; there are "));
  EXPECT_THAT(refusalOf("[effect zzzzzz]\n"), HasSubstr("coulomb"));
}

TEST(WrongModelFileAsAWhole, EveryNumberIsRefusedOutsideItsRangeAndAcceptedAtItsEnds) {
  for (const KeyRow& row : keyTable()) {
    Model model;
    if (!std::holds_alternative<double*>(row.in(model))) continue;
    SCOPED_TRACE(row.key);
    const std::string unit{row.number.unit};
    for (const double end : {row.number.low, row.number.high})
      EXPECT_NO_THROW(readValue(model, row, writeNumber(end, row.number)));
    for (const double beyond : {row.number.low - 1e-6, row.number.high * 1.001})
      EXPECT_THAT(refusal([&] { readValue(model, row, writeNumber(beyond, row.number)); }),
                  StartsWith(messages::kOutOfRange));
  }
}

TEST(DamagedModelFile, IsRefusedForAZeroByte) {
  const std::string text = "[model]\nname = mine\n[servo]\nkt = 1 N m/A" + std::string{'\0'} + "junk\n";
  try {
    (void)parseModel(text, "my.ini");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "my.ini, line 4: there is a zero byte, so this is not a text file, or a damaged one");
  }
}

}  // namespace
}  // namespace darwinop::twin
