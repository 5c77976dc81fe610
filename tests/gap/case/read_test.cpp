// The values of a case.json are read into our names and units.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> priorsOf(const Case& c) {
  std::vector<std::string> names;
  for (const Prior& prior : c.priors) names.push_back(prior.number);
  return names;
}

TEST(CaseRead, NumbersOfTheVoltageLaw) {
  const Case c = CaseTexts{}.read();
  EXPECT_EQ(c.name, "tiny");
  EXPECT_EQ(c.folder, "my");
  EXPECT_EQ(c.goal_order, GoalOrder::kAfterRead);
  EXPECT_TRUE(c.quantised);
  EXPECT_EQ(c.model.servo.law, twin::Law::kVoltageP);
  EXPECT_EQ(c.model.servo.kt_nm_a, 1.8);
  EXPECT_EQ(c.model.servo.back_emf_vs_rad, 1.8);  // of the baseline's equation
  EXPECT_EQ(c.model.servo.resistance_ohm, 8.5);
  EXPECT_EQ(c.pendulum.length_m, 0.17);
  EXPECT_EQ(c.pendulum.arm_mass_kg, 0.04);
  EXPECT_THAT(c.warnings, ElementsAre());
}

TEST(CaseRead, FrictionBecomesAnEffectUnlessItIsZero) {
  const Case c = CaseTexts{}.read();
  ASSERT_EQ(c.model.effects.size(), 1u);  // viscous is 0
  EXPECT_EQ(c.model.effects[0].info->id, "coulomb");
  EXPECT_THAT(c.model.effects[0].values, ElementsAre(0.08));
}

TEST(CaseRead, PriorsOfWhatIsNotThereAreDropped) {
  EXPECT_THAT(priorsOf(CaseTexts{}.read()), ElementsAre("kt", "resistance", "payload", "coulomb.friction"));
}

TEST(CaseRead, ScoreIsReadAsHeldOut) {
  EXPECT_TRUE(CaseTexts{}.with("\"role\": \"score\"", "\"role\": \"held_out\"").read().logs[1].held_out);
  EXPECT_TRUE(CaseTexts{}.read().logs[1].held_out) << "the former word";
}

TEST(CaseRead, PriorsOfNumbersThatNothingMovesAreReported) {
  const Case given = CaseTexts{}.with("\"kt_Nm_A\": 0.02", "\"duty_max\": 0.02").read();
  EXPECT_THAT(given.warnings, testing::Contains(HasSubstr(messages::kNeverMoved)));
  EXPECT_THAT(priorsOf(given), testing::Not(testing::Contains("duty_max")));
  EXPECT_EQ(CaseTexts{}.with("\"kt_Nm_A\": 0.02", "\"arm_mass_kg\": 0.02").error(), "");
}

TEST(CaseRead, APartOfALogInUnixTime) {
  EXPECT_EQ(CaseTexts{}.with("\"kp\": 32", "\"from_s\": -1768489200, \"to_s\": 1768489200, \"kp\": 32").error(), "");
}

TEST(CaseRead, RowsInSi) {
  const Case c = CaseTexts{}.read();
  ASSERT_EQ(c.logs.size(), 2u);
  const Trajectory& log = c.logs[0];
  const CsvRow row = sineRows()[10];
  EXPECT_EQ(log.kind, "sine");
  EXPECT_FALSE(log.held_out);
  EXPECT_TRUE(c.logs[1].held_out);
  EXPECT_EQ(log.session_start_s, 1.5);
  EXPECT_EQ(log.lines[10], 12u);
  EXPECT_NEAR(log.position_rad[10], row.pos, 1e-6);
  EXPECT_NEAR(log.load[10], row.load / 100, 1e-6);  // a share, not per cent
  EXPECT_EQ(log.torque_on[10], 1);
  EXPECT_EQ(log.temp_c[10], 30);
}

TEST(CaseRead, ColumnsThatAreNotThereAreNotKnown) {
  CaseTexts texts;
  texts.logs["fit_1.csv"] = "t_s,goal_rad,torque_on,pos_rad\n";
  for (const CsvRow& r : sineRows())
    texts.logs["fit_1.csv"] +=
        std::to_string(r.t) + "," + std::to_string(r.goal) + ",1," + std::to_string(r.pos) + "\n";
  const Case c = texts.read();
  ASSERT_EQ(c.logs[0].load.size(), c.logs[0].rows());
  EXPECT_TRUE(std::isnan(c.logs[0].load[5]));
  EXPECT_TRUE(std::isnan(c.logs[0].volt_v[5]));
}

TEST(CaseRead, DegreesAndRpmAreConvertedWhenTheNameSaysSo) {
  CaseTexts texts;
  std::vector<CsvRow> rows = sineRows();
  for (CsvRow& r : rows) r.goal *= 180 / kPi, r.pos *= 180 / kPi, r.speed *= 30 / kPi;
  texts.logs["fit_1.csv"] = csvOf(rows, "t_s,goal_deg,torque_on,pos_deg,speed_rpm,load_pct,volt_V,temp_C");
  const Case c = texts.read();
  EXPECT_NEAR(c.logs[0].position_rad[50], sineRows()[50].pos, 1e-5);
  EXPECT_NEAR(c.logs[0].speed_rad_s[50], sineRows()[50].speed, 1e-3);
}

const char* const kSpeedParams = R"("speed_gain_per_kp_1_s": 0.3125, "v_max_rad_s": 5.76, "torque_max_Nm": 2.5,)";
const char* const kVoltageParams =
    R"("kt_Nm_A": 1.8, "R_ohm": 8.5, "supply_V": 12.0, "duty_per_kp_per_rad": 0.158, "duty_max": 1.0,)";

TEST(CaseRead, TheSpeedLawTakesItsMotorFromTheDataSheet) {
  const Case c = CaseTexts{}
                     .with(kVoltageParams, kSpeedParams)
                     .with("\"voltage_p\"", "\"speed_p\"")
                     .with("\"logs\"", R"("servo_datasheet": {"name": "MX-28", "stall_Nm": 2.5, "stall_A": 1.4,
                       "no_load_rpm": 55, "kt_Nm_A": 1.786, "R_ohm": 8.57, "duty_per_kp_per_rad": 0.15,
                       "duty_max": 0.9, "supply_V": 11.5, "rel_sigma": 0.07, "gear_ratio": 193}, "logs")")
                     .read();
  EXPECT_EQ(c.model.servo.law, twin::Law::kSpeedP);
  EXPECT_EQ(c.model.servo.speed_max_rad_s, 5.76);
  ASSERT_TRUE(c.datasheet.has_value());
  EXPECT_EQ(c.datasheet->relative_sigma, 0.07);
  for (const twin::ServoParameters& servo : {c.model.servo, c.datasheet->servo}) {
    EXPECT_EQ(servo.kt_nm_a, 1.786);
    EXPECT_EQ(servo.back_emf_vs_rad, 1.786);
    EXPECT_EQ(servo.resistance_ohm, 8.57);
    EXPECT_EQ(servo.duty_per_kp_per_rad, 0.15);
    EXPECT_EQ(servo.supply_v, 11.5);
  }
  EXPECT_THAT(priorsOf(c), ElementsAre("payload", "coulomb.friction"));  // the baseline has no kt
}

TEST(CaseRead, ADataSheetAtItsOwnVoltage) {
  const Case c = CaseTexts{}
                     .with("\"logs\"", R"("servo_datasheet": {"stall_Nm_at_5V": 0.52, "stall_A_at_5V": 1.47,
                       "no_load_rpm_at_5V": 104, "position_p_divisor": 128, "pwm_limit": 885}, "logs")")
                     .read();
  ASSERT_TRUE(c.datasheet.has_value());
  EXPECT_NEAR(c.datasheet->servo.kt_nm_a, 0.52 / 1.47, 1e-12);
  EXPECT_NEAR(c.datasheet->servo.resistance_ohm, 5 / 1.47, 1e-12);
  EXPECT_NEAR(c.datasheet->servo.duty_per_kp_per_rad, 0.005755, 1e-6);
  EXPECT_NEAR(c.datasheet->servo.speed_max_rad_s, 10.89 * 12 / 5, 0.01);  // at the supply of the baseline
  EXPECT_EQ(c.model.servo.kt_nm_a, 1.8);                                  // the baseline stays
}

TEST(CaseRead, OtherKeysOfADataSheetAreIgnored) {
  const Case c = CaseTexts{}.with("\"logs\"", R"("servo_datasheet": {"colour": "black"}, "logs")").read();
  EXPECT_THAT(c.warnings, ElementsAre(HasSubstr("servo_datasheet.colour")));
}

TEST(CaseRead, KeysOfOtherProgramsAreIgnoredWithAWarning) {
  const Case c = CaseTexts{}
                     .with("\"family\"", R"("bench_serial": 7, "family")")
                     .with("\"kp\": 32", R"("weather": "dry", "kp": 32)")
                     .with("\"kt_Nm_A\": 0.02", R"("kt_Nm_A": 0.02, "spin_Nm": 0.1)")
                     .read();
  EXPECT_THAT(c.warnings, ElementsAre(StartsWith("my/case.json: \"logs[0].weather\" "),
                                      StartsWith("my/case.json: \"prior_rel_sigma.spin_Nm\" "),
                                      StartsWith("my/case.json: \"bench_serial\" ")));
}

TEST(CaseRead, AFastFirmwareHasAFinerEncoderThanItsRegisters) {
  EXPECT_FALSE(CaseTexts{}.with("\"firmware_dt_s\": 0.001", "\"firmware_dt_s\": 0.0001").read().quantised);
  EXPECT_TRUE(CaseTexts{}
                  .with("\"firmware_dt_s\": 0.001", "\"firmware_dt_s\": 0.0001, \"position_in_ticks\": true")
                  .read()
                  .quantised);
}

TEST(CaseRead, StepsOfTheEncoderAreRequiredWhereTheFirmwareUsesThem) {
  const CaseTexts without = CaseTexts{}.with(", \"ticks_per_rev\": 4096", "");
  EXPECT_THAT(without.error(), HasSubstr("`baseline.params.ticks_per_rev` is missing"));
  EXPECT_EQ(without.with("\"firmware_dt_s\": 0.001", "\"firmware_dt_s\": 0.0001").error(), "");
}

TEST(CaseRead, GoalsBeforeTheRead) {
  const Case c = CaseTexts{}.with("\"family\"", "\"goal_order\": \"before_read\", \"family\"").read();
  EXPECT_EQ(c.goal_order, GoalOrder::kBeforeRead);
}

TEST(CaseRead, AModelFileInPlaceOfABaseline) {
  CaseTexts texts;
  const std::size_t from = texts.json.find("\"baseline\""), to = texts.json.find("\"prior_rel_sigma\"");
  texts.json.replace(from, to - from, R"("model": "my.ini", "arm": {"arm_mass_kg": 0.01, "length_m": 0.2}, )");
  texts.json = replaced(texts.json, "\"coulomb_Nm\"", "\"backlash.play\": 0.5, \"coulomb.friction\"");
  texts.models["my.ini"] =
      "[model]\nname = mine\n[servo]\nback_emf = 1.9 V s/rad\n[effect coulomb]\nfriction = 0.03 N m\n";
  const Case c = texts.read();
  EXPECT_EQ(c.model.name, "mine");
  EXPECT_EQ(c.model.servo.back_emf_vs_rad, 1.9);
  EXPECT_EQ(c.pendulum.length_m, 0.2);
  EXPECT_THAT(priorsOf(c), ElementsAre("kt", "resistance", "payload", "coulomb.friction"));
}

TEST(CaseRead, AFolder) {
  const TemporaryFolder folder;
  const CaseTexts texts;
  std::ofstream{folder / "case.json"} << texts.json;
  for (const auto& [name, text] : texts.logs) std::ofstream{folder / name} << text;
  const std::string path = std::filesystem::path{folder / "case.json"}.parent_path();
  const Case c = readCase(path);
  EXPECT_EQ(c.folder, path);
  EXPECT_EQ(c.logs.size(), 2u);
}

TEST(CaseRead, APipeInPlaceOfALogIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const CaseTexts texts;
  std::ofstream{folder / "case.json"} << texts.json;
  for (const auto& [name, text] : texts.logs) ASSERT_EQ(mkfifo((folder / name).c_str(), 0600), 0);
  try {
    readCase(std::filesystem::path{folder / "case.json"}.parent_path());
    FAIL();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr(messages::kNotRegular));
  }
}

TEST(CaseRead, AnErrorForAFolderWithoutACaseSuggestsHowToMakeOne) {
  const TemporaryFolder folder;
  try {
    readCase(folder / "");
    FAIL();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), AllOf(HasSubstr(folder / "case.json"), HasSubstr("docs/gap/cases.md")));
  }
}

TEST(CaseRead, ALogHasItsOwnBench) {
  const std::string own = "\"payload_kg\": 0.3, \"arm_mass_kg\": 0.1, \"length_m\": 0.2, \"supply_V\": 11";
  const Case c = CaseTexts{}.with("\"payload_kg\": 0.3", own).read();
  EXPECT_EQ(c.logs[0].length_m, 0.2);
  EXPECT_EQ(c.logs[0].arm_mass_kg, 0.1);
  EXPECT_EQ(supplyOf(c, c.logs[0]), 11);
  EXPECT_EQ(armOf(c, c.logs[0]).length_m, 0.2);
  EXPECT_EQ(armOf(c, c.logs[1]).length_m, 0.17);
  EXPECT_EQ(supplyOf(c, c.logs[1]), 12);
  EXPECT_NE(CaseTexts{}.with("\"payload_kg\": 0.3", "\"payload_kg\": 0.3, \"length_m\": 0").error(), "");
  // Without that of the case every log needs one.
  CaseTexts all = CaseTexts{}.with(", \"length_m\": 0.17", "");
  EXPECT_NE(all.error(), "");
  all = all.with("\"payload_kg\": 0.3, \"t0_session_s\": 1.5", "\"payload_kg\": 0.3, \"length_m\": 0.2");
  all = all.with("\"payload_kg\": 0.3, \"t0_session_s\": 9", "\"payload_kg\": 0.3, \"length_m\": 0.3");
  EXPECT_EQ(all.read().pendulum.length_m, 0.2);
}

// A robot's results go to that joint's section of its model.
TEST(CaseRead, ItsJointIsOneOfTheRobotOrSaysNothing) {
  const auto with = [](const std::string& joint) {
    return CaseTexts{}.with("\"logs\"", "\"joint\": \"" + joint + "\", \"logs\"").read();
  };
  EXPECT_EQ(with("Neck").joint, Joint::kNeck);
  EXPECT_THAT(with("Neck").warnings, ElementsAre());
  const Case arm = with("Elbow");
  EXPECT_EQ(arm.joint, std::nullopt);
  EXPECT_THAT(arm.warnings, ElementsAre(HasSubstr(messages::kOfAnotherRobot)));
}

}  // namespace
}  // namespace darwinop::gap
