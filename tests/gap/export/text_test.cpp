// The exported files are well formed, with the model's numbers to the last bit.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "core/text/number_text.hpp"
#include "gap/export/export_rig.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Believed wornServo() {
  Believed model;
  model.friction().with("backlash", "play", 0.0123).with("kp_scale", "scale", 1.0 / 1.7);
  return model;
}

/// Nodes and fields of a PROTO: "RotationalMotor.maxTorque" to its words. Throws for braces that do not match.
std::map<std::string, std::vector<std::string>> webotsFieldsIn(const std::string& text) {
  std::istringstream lines{text};
  std::map<std::string, std::vector<std::string>> found;
  std::vector<std::string> open;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words{line.substr(0, line.find('#'))};
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    if (all.empty()) continue;
    if (all.back() == "{" || all.back() == "[") {
      open.push_back((all.size() > 1 ? all[all.size() - 2] : "") + all.back());
    } else if (all[0] == "}" || all[0] == "]") {
      if (open.empty() || open.back().back() != (all[0] == "}" ? '{' : '['))
        throw std::runtime_error("braces: " + line);
      open.pop_back();
    } else {
      if (open.empty()) throw std::runtime_error("outside of a node: " + line);
      const std::string node = open.back().substr(0, open.back().size() - 1);
      found[node + "." + all[0]] = {all.begin() + 1, all.end()};
    }
  }
  if (!open.empty()) throw std::runtime_error("a brace too few");
  return found;
}

double number(const std::string& text) {
  return text::numberFromText(text).value_or(-12345);
}

/// Value of an attribute of the first tag that begins so.
std::string attributeIn(const std::string& xml, const std::string& tag, const std::string& key) {
  const std::size_t at = xml.find("<" + tag);
  if (at == xml.npos) return "no <" + tag;
  const std::string inside = xml.substr(at, xml.find('>', at) - at);
  const std::size_t from = inside.find(" " + key + "=\"");
  if (from == inside.npos) return "no " + key;
  const std::size_t begin = from + key.size() + 3;
  return inside.substr(begin, inside.find('"', begin) - begin);
}

TEST(ExportText, WebotsFieldsComeBackToTheLastBit) {
  const Believed model = wornServo();
  const auto text = exportTo(Target::kWebots, model.get(), forArm()).text;
  const auto in = webotsFieldsIn(text);
  const WebotsFields f = webotsFields(numbersOf(model.get(), forArm().conditions()));
  EXPECT_EQ(number(in.at("RotationalMotor.maxVelocity").at(0)), f.max_velocity);
  EXPECT_EQ(number(in.at("RotationalMotor.acceleration").at(0)), -1);
  EXPECT_EQ(number(in.at("RotationalMotor.maxTorque").at(0)), f.max_torque);
  EXPECT_EQ(number(in.at("RotationalMotor.controlPID").at(0)), f.p);
  EXPECT_EQ(number(in.at("HingeJointParameters.dampingConstant").at(0)), 0.01);
  EXPECT_EQ(number(in.at("HingeJointParameters.staticFriction").at(0)), 0.06);
  EXPECT_EQ(number(in.at("HingeJointWithBacklash.gap").at(0)), 0.0123);
  EXPECT_EQ(number(in.at("PositionSensor.resolution").at(0)), f.resolution);
  EXPECT_THAT(in.at("RotationalMotor.name"), ElementsAre("\"ArmUpperR\""));
  EXPECT_THAT(in.at("PositionSensor.name"), ElementsAre("\"ArmUpperRS\""));  // as controllers ask for it
}

TEST(ExportText, AWebotsJointWithoutPlayIsAPlainHinge) {
  const std::string text = exportTo(Target::kWebots, Believed{}.get(), forArm()).text;
  EXPECT_THAT(text, HasSubstr("\nHingeJoint {"));
  EXPECT_EQ(webotsFieldsIn(text).count("HingeJoint.gap"), 0u);
}

TEST(ExportText, MujocoNumbersComeBackToTheLastBit) {
  const Believed model = wornServo();
  const ServoNumbers servo = numbersOf(model.get(), forArm().conditions());
  const std::string xml = exportTo(Target::kMujoco, model.get(), forArm()).text;
  EXPECT_EQ(number(attributeIn(xml, "joint ", "frictionloss")), 0.06);
  EXPECT_EQ(number(attributeIn(xml, "joint ", "damping")), 0.01);
  EXPECT_EQ(number(attributeIn(xml, "joint ", "armature")), servo.armature_kgm2);
  EXPECT_EQ(number(attributeIn(xml, "general name=\"ArmUpperR\"", "gainprm")), servo.stiffness_nm_rad);
  EXPECT_EQ(attributeIn(xml, "joint name=\"ArmUpperR_play\"", "range"), "-0.00615 0.00615");
}

TEST(ExportText, MujocoWritesThePlayOfABendingJointOrNamesItAsLost) {
  Believed model;
  model.with("backlash", "play", 0.02).with("joint_flex", "stiffness", 30).with("joint_flex", "damping", 0.02);
  const Export made = exportTo(Target::kMujoco, model.get(), forArm());
  const bool is_lost = std::ranges::any_of(
      made.lost, [](const std::string& sentence) { return sentence.find("loses backlash") != sentence.npos; });
  EXPECT_NE(made.text.find("_play\"") != made.text.npos, is_lost) << testing::PrintToString(made.lost);
  EXPECT_THAT(made.text, HasSubstr("_flex\""));
}

TEST(ExportText, UrdfNumbersComeBackToTheLastBit) {
  const Believed model = wornServo();
  const ServoNumbers servo = numbersOf(model.get(), forArm().conditions());
  const std::string xml = exportTo(Target::kUrdf, model.get(), forArm()).text;
  EXPECT_EQ(number(attributeIn(xml, "dynamics", "friction")), 0.06);
  EXPECT_EQ(number(attributeIn(xml, "dynamics", "damping")), 0.01);
  EXPECT_EQ(number(attributeIn(xml, "limit", "effort")), servo.top_torque_nm);
  EXPECT_EQ(number(attributeIn(xml, "limit", "velocity")), servo.top_speed_rad_s);
}

// The data sheet: 2.5 N m at stall; 12 V against its back EMF are 64 rpm less friction.
TEST(ExportText, ADataSheetServoHasTheSheetsNumbers) {
  const ServoNumbers servo = numbersOf(Believed{}.get(), {});
  EXPECT_NEAR(servo.top_torque_nm, 2.5, 1e-9);
  EXPECT_NEAR(servo.top_speed_rad_s, 12 / (2.5 / 1.4), 1e-9);
  EXPECT_NEAR(servo.stiffness_nm_rad, 2.5 * 0.158 * 32, 1e-9);
  EXPECT_FALSE(std::isfinite(servo.top_accel_rad_s2));
}

TEST(ExportText, AHalfGainHalvesWhatStandsForP) {
  ExportSettings half = forArm();
  half.p_register = 16;
  const ServoNumbers whole = numbersOf(Believed{}.get(), forArm().conditions());
  const ServoNumbers less = numbersOf(Believed{}.get(), half.conditions());
  EXPECT_DOUBLE_EQ(less.stiffness_nm_rad, whole.stiffness_nm_rad / 2);
  EXPECT_DOUBLE_EQ(less.speed_per_error_1_s, whole.speed_per_error_1_s / 2);
}

TEST(ExportText, TheModelOfTheThesisKeepsItsNumbersInWebots) {
  Believed model;
  model.bySpeed().with("accel_limit", "accel", 55).with("coulomb", "friction", 0.025).with("viscous", "damping", 0.002);
  const auto in = webotsFieldsIn(exportTo(Target::kWebots, model.get(), forArm()).text);
  EXPECT_EQ(number(in.at("RotationalMotor.acceleration").at(0)), 55);
  EXPECT_EQ(number(in.at("RotationalMotor.maxVelocity").at(0)), 12.26);
  EXPECT_EQ(number(in.at("RotationalMotor.controlPID").at(0)), 4);  // register 32
  EXPECT_EQ(number(in.at("HingeJointParameters.staticFriction").at(0)), 0.025);
}

TEST(ExportText, WhatCannotBeWrittenIsRefusedWithAMessage) {
  const auto refusal = [](auto change) {
    ExportSettings settings = forArm();
    change(settings);
    try {
      exportTo(Target::kMujoco, Believed{}.get(), settings);
    } catch (const std::runtime_error& refused) {
      return std::string{refused.what()};
    }
    return std::string{"written"};
  };
  EXPECT_THAT(refusal([](ExportSettings& s) { s.joint = "Arm\"><x/>"; }), HasSubstr("\"Arm\"><x/>\""));
  EXPECT_THAT(refusal([](ExportSettings& s) { s.p_register = 0; }), HasSubstr("1 to 254"));
  EXPECT_THAT(refusal([](ExportSettings& s) { s.step_s = 2; }), HasSubstr("usual one is 0.002 s"));
}

TEST(ExportText, ACommentCannotEndOne) {
  ExportSettings settings = forArm();
  settings.model = "my--model";
  const std::string xml = exportTo(Target::kUrdf, Believed{}.get(), settings).text;
  EXPECT_THAT(xml, HasSubstr("my- -model"));
}

}  // namespace
}  // namespace darwinop::gap
