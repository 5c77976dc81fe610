// Servos whose data sheet is known: their logs need no declaration, and every number can be declared.
#include "gap/case/known_servos.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "gap/case/messages.hpp"
#include "gap/case/raw_folder_rig.hpp"
#include "gap/case/write_case.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

struct KnownServos : RawFolderTest {
  void addMotor(const std::string& name, const std::string& motor, int kp = 32) const {
    write(folder / (name + ".json"),
          bamText(zero, zero, "\"kp\": " + std::to_string(kp) + ", \"motor\": \"" + motor + "\""));
  }
  [[nodiscard]] FolderCase declaring(std::vector<std::string> words) const {
    return readRawFolder({.folder = folder / "", .model = "", .declared = std::move(words), .held_out = {}});
  }
};

double sigmaOf(const Case& c, std::string_view number) {
  const auto found = std::ranges::find(c.priors, number, &Prior::number);
  return found == c.priors.end() ? 0 : found->relative_sigma;
}

TEST(MotorName, IsTolerantOfSpelling) {
  for (const char* const written : {"mx106", "MX-106", "Dynamixel MX 106R", "mx_106_left"})
    EXPECT_EQ(motorName(written), "mx106") << written;
  EXPECT_EQ(motorName("MX-64(2.0)"), motorName("mx64 2.0"));
  EXPECT_NE(motorName("MX-64(2.0)"), motorName("mx64"));
  EXPECT_EQ(motorName("erob80_100"), "erob80_100");
  EXPECT_EQ(motorName("mx"), "mx");
}

TEST_F(KnownServos, AnMx106NeedsNoDeclaration) {
  addMotor("a", "mx106");
  addMotor("b", "MX-106");
  const FolderCase read = declaring({});
  const twin::ServoParameters& servo = read.given.model.servo;
  EXPECT_NEAR(servo.resistance_ohm, 12 / 5.2, 1e-9);
  EXPECT_GT(servo.kt_nm_a, 8.4 / 5.2) << "friction takes from the torque at stall";
  EXPECT_LT(servo.kt_nm_a, 12 / 4.712) << "and from the speed without load, 45 rpm";
  EXPECT_GT(sigmaOf(read.given, "kt"), 0.2) << "both are within it";
  EXPECT_EQ(servo.duty_per_kp_per_rad, 0.158);
  EXPECT_NEAR(servo.armature_kgm2, 0.0123, 1e-4);
  EXPECT_EQ(sigmaOf(read.given, "armature"), 1);
  EXPECT_TRUE(read.given.model.effects.empty()) << "friction of an MX-28";
  for (const char* const key : {"stall_Nm_at_12V=8.4", "stall_A_at_12V=5.2", "kt_Nm_A=", "duty_per_kp_per_rad=0.158"})
    EXPECT_THAT(read.notes, Contains(AllOf(HasSubstr(key), HasSubstr(messages::kSheetNumber))));
  EXPECT_THAT(read.notes, Contains(AllOf(HasSubstr("armature_kgm2"), HasSubstr(messages::kNotOnSheet))));
  writeCase(read.given, out / "case");
  const Case back = readCase(out / "case");
  EXPECT_EQ(back.model.servo.kt_nm_a, servo.kt_nm_a);
  EXPECT_EQ(sigmaOf(back, "armature"), 1);
}

TEST_F(KnownServos, OfSeveralMotorsOneIsDeclaredOrHasNearlyAllLogs) {
  addMotor("a", "mx106");
  addMotor("b", "mx64");
  try {
    (void)declaring({});
    ADD_FAILURE();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), AllOf(HasSubstr(messages::kSeveralMotors), HasSubstr("mx106 (1), mx64 (1)")));
  }
  write(folder / "c.json", bamText(zero, zero, "\"kp\": 8"));
  const FolderCase chosen = declaring({"motor=MX-64"});
  EXPECT_EQ(chosen.motor, "mx64");
  EXPECT_EQ(chosen.given.logs.size(), 2u) << "and the one without a name";
  EXPECT_THAT(chosen.notes, Contains(AllOf(HasSubstr(messages::kOtherMotors), HasSubstr("mx106 (1)"))));
  EXPECT_THROW((void)declaring({"motor=mx28"}), BadInput) << "none of them";
  std::filesystem::remove(folder / "c.json");
  for (int i = 0; i < 8; ++i) addMotor("d" + std::to_string(i), "mx64");
  const FolderCase nearly = declaring({});
  EXPECT_EQ(nearly.motor, "mx64");
  EXPECT_EQ(nearly.given.logs.size(), 9u);
}

TEST_F(KnownServos, ADeclaredMotorIsThatOfLogsWithAnotherName) {
  addMotor("a", "shoulder");
  EXPECT_THROW((void)declaring({}), BadInput);
  EXPECT_NEAR(declaring({"motor=mx64"}).given.model.servo.resistance_ohm, 12 / 4.1, 1e-9);
}

TEST_F(KnownServos, AnMx64IsAnotherOne) {
  addMotor("a", "MX-64");
  const twin::ServoParameters servo = declaring({}).given.model.servo;
  EXPECT_NEAR(servo.resistance_ohm, 12 / 4.1, 1e-9);
  EXPECT_NEAR(servo.kt_nm_a, 1.63, 0.01);
  EXPECT_NEAR(servo.armature_kgm2, 0.0063, 1e-4);
}

TEST_F(KnownServos, EachNumberCanBeDeclared) {
  addMotor("a", "mx106");
  const FolderCase read = declaring({"stall_Nm_at_14.8V=10", "stall_A_at_14.8V=6.3", "armature_kgm2=0.02",
                                     "duty_per_kp_per_rad=0.1", "armature_kgm2_rel_sigma=0.3"});
  const twin::ServoParameters& servo = read.given.model.servo;
  EXPECT_NEAR(servo.kt_nm_a, 10 / 6.3, 1e-9);
  EXPECT_EQ(servo.armature_kgm2, 0.02);
  EXPECT_EQ(servo.duty_per_kp_per_rad, 0.1);
  EXPECT_EQ(sigmaOf(read.given, "armature"), 0.3);
  EXPECT_EQ(sigmaOf(read.given, "kt"), 0.1) << "of every bench";
  EXPECT_THAT(read.notes, Not(Contains(HasSubstr(messages::kSheetNumber))));
  EXPECT_EQ(declaring({"kt_Nm_A=1.9"}).given.model.servo.kt_nm_a, 1.9);
  try {
    (void)declaring({"pwm_limit=1023"});
    ADD_FAILURE() << "and its divisor?";
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("position_p_divisor"));
  }
}

TEST_F(KnownServos, AKpBeyond254IsOfProtocol2) {
  constexpr double kGain = 4096 / (2 * 3.14159265358979) / 128 / 885;
  addMotor("a", "mx106", 200);
  addMotor("b", "mx106", 400);
  EXPECT_NEAR(declaring({}).given.model.servo.duty_per_kp_per_rad, kGain, 1e-9);
  addMotor("a", "mx28", 850);
  addMotor("b", "mx28", 850);
  const twin::ServoParameters mx28 = declaring({}).given.model.servo;
  EXPECT_NEAR(mx28.duty_per_kp_per_rad, kGain, 1e-9);
  EXPECT_EQ(mx28.armature_kgm2, 0.003);
  addMotor("a", "MX-64(2.0)", 100);
  addMotor("b", "MX-64(2.0)", 100);
  EXPECT_NEAR(declaring({}).given.model.servo.duty_per_kp_per_rad, kGain, 1e-9);
}

}  // namespace
}  // namespace darwinop::gap
