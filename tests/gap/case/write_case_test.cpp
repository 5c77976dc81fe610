// What is written is read back as it was.
#include "gap/case/write_case.hpp"

#include <gmock/gmock.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "gap/case/case_texts.hpp"
#include "support/temporary_folder.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr double kClose = 1e-7;

void expectSame(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(std::isnan(a[i]), std::isnan(b[i]));
    if (std::isnan(a[i])) continue;
    EXPECT_NEAR(a[i], b[i], kClose);
  }
}

void expectSame(const Trajectory& a, const Trajectory& b) {
  EXPECT_EQ(a.file, b.file);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.held_out, b.held_out);
  EXPECT_EQ(a.repeat_of, b.repeat_of);
  EXPECT_EQ(a.p_register, b.p_register);
  EXPECT_EQ(a.payload_kg, b.payload_kg);
  EXPECT_EQ(a.session_start_s, b.session_start_s);
  EXPECT_EQ(a.is_session_known, b.is_session_known);
  EXPECT_EQ(a.speed_limit_rad_s, b.speed_limit_rad_s);
  EXPECT_EQ(a.torque_on, b.torque_on);
  expectSame(a.time_s, b.time_s);
  expectSame(a.goal_rad, b.goal_rad);
  expectSame(a.position_rad, b.position_rad);
  expectSame(a.speed_rad_s, b.speed_rad_s);
  expectSame(a.load, b.load);
  expectSame(a.volt_v, b.volt_v);
  expectSame(a.temp_c, b.temp_c);
  expectSame(a.written_s, b.written_s);
  expectSame(a.read_s, b.read_s);
  EXPECT_EQ(a.is_phase_known, b.is_phase_known);
}

/// Writes it, reads it and compares.
void expectRoundTrip(const Case& c) {
  const TemporaryFolder folder;
  writeCase(c, folder / "case");
  const Case back = readCase(folder / "case");
  EXPECT_EQ(back.name, c.name);
  EXPECT_EQ(back.goal_order, c.goal_order);
  EXPECT_EQ(back.quantised, c.quantised);
  EXPECT_EQ(twin::writeModel(back.model), twin::writeModel(c.model));
  EXPECT_EQ(back.pendulum.length_m, c.pendulum.length_m);
  EXPECT_EQ(back.pendulum.arm_mass_kg, c.pendulum.arm_mass_kg);
  EXPECT_EQ(back.pendulum.gravity_m_s2, c.pendulum.gravity_m_s2);
  ASSERT_EQ(back.priors.size(), c.priors.size());
  for (std::size_t i = 0; i < c.priors.size(); ++i) {
    EXPECT_EQ(back.priors[i].number, c.priors[i].number);
    EXPECT_EQ(back.priors[i].relative_sigma, c.priors[i].relative_sigma);
  }
  ASSERT_EQ(back.datasheet.has_value(), c.datasheet.has_value());
  if (c.datasheet) {
    EXPECT_EQ(back.datasheet->relative_sigma, c.datasheet->relative_sigma);
    EXPECT_EQ(back.datasheet->servo.kt_nm_a, c.datasheet->servo.kt_nm_a);
    EXPECT_EQ(back.datasheet->servo.speed_max_rad_s, c.datasheet->servo.speed_max_rad_s);
  }
  ASSERT_EQ(back.logs.size(), c.logs.size());
  for (std::size_t i = 0; i < c.logs.size(); ++i) expectSame(back.logs[i], c.logs[i]);
}

TEST(WriteCase, ABaseline) {
  Case c = CaseTexts{}.read();
  EXPECT_TRUE(fitsBaseline(c));
  expectRoundTrip(c);
  c.goal_order = GoalOrder::kBeforeRead;
  c.quantised = false;
  c.logs[0].speed_limit_rad_s = 2;
  for (std::size_t i = 10; i < 60; ++i) c.logs[0].torque_on[i] = 0;
  c.logs[0].volt_v[7] = std::nan("");
  c.logs[1].load.assign(c.logs[1].rows(), std::nan(""));
  expectRoundTrip(c);
}

TEST(WriteCase, WhenEachRowWasWrittenAndRead) {
  Case c = CaseTexts{}.read();
  for (const std::size_t i : {0U, 1U}) {
    c.logs[i].written_s.assign(c.logs[i].rows(), 0.00068);
    c.logs[i].read_s.assign(c.logs[i].rows(), 0.00174);
    c.logs[i].is_phase_known = i == 0;
  }
  expectRoundTrip(c);
}

TEST(WriteCase, ASessionWithoutClockStaysSo) {
  const CaseTexts clockless = CaseTexts{}.with(", \"t0_session_s\": 1.5", "").with(", \"t0_session_s\": 9", "");
  const Case c = clockless.read();
  EXPECT_FALSE(c.logs[0].is_session_known);
  EXPECT_TRUE(CaseTexts{}.read().logs[0].is_session_known);
  expectRoundTrip(c);
}

TEST(WriteCase, UnixTime) {
  Case c = CaseTexts{}.read();
  for (double& time_s : c.logs[0].time_s) time_s += 1768489200.123;
  expectRoundTrip(c);
}

TEST(WriteCase, ADataSheetAndTheSpeedLaw) {
  const CaseTexts sheet = CaseTexts{}.with(
      "\"logs\"", R"("servo_datasheet": {"kt_Nm_A": 1.7, "R_ohm": 8, "no_load_rpm": 55, "rel_sigma": 0.1}, "logs")");
  expectRoundTrip(sheet.read());
  Case c = sheet.read();
  c.model.servo.law = twin::Law::kSpeedP;
  c.priors = {{"length", 0.01}};
  EXPECT_TRUE(fitsBaseline(c));
  expectRoundTrip(c);
}

TEST(WriteCase, AVerticalAxis) {
  const Case c = CaseTexts{}.with("\"logs\"", R"("axis": "vertical", "logs")").read();
  EXPECT_EQ(c.pendulum.gravity_m_s2, 0);
  EXPECT_GT(CaseTexts{}.read().pendulum.gravity_m_s2, 9);
  expectRoundTrip(c);
}

TEST(WriteCase, AModelThatABaselineCannotHold) {
  Case c = CaseTexts{}.read();
  c.model.effects.push_back({twin::findEffect("backlash"), {0.006}, std::nullopt});
  EXPECT_FALSE(fitsBaseline(c));
  expectRoundTrip(c);
  c = CaseTexts{}.read();
  c.model.servo.back_emf_vs_rad = 1.9;
  EXPECT_FALSE(fitsBaseline(c));
  expectRoundTrip(c);
}

TEST(WriteCase, WritesOnlyColumnsThatAreKnown) {
  Case c = CaseTexts{}.read();
  c.logs[0].temp_c.assign(c.logs[0].rows(), std::nan(""));
  EXPECT_THAT(logAsCsv(c.logs[0]),
              testing::StartsWith("t_s,goal_rad,torque_on,pos_rad,speed_rad_s,load_pct,volt_V\n0,"));
}

TEST(WriteCase, SaysWhereItCannotWrite) {
  const TemporaryFolder folder;
  const Case c = CaseTexts{}.read();
  writeCase(c, folder / "case");
  try {
    writeCase(c, folder / "case/case.json");  // a file
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr((folder / "case/case.json") + "/case.json: " + std::strerror(ENOTDIR)));
  }
}

}  // namespace
}  // namespace darwinop::gap
