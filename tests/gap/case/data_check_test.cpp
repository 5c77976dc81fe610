// The data check before any fit.
#include "gap/case/data_check.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// True: the case satisfies a rule.
bool reveals(const Case& c, std::string_view id) {
  const DataCheck check = checkData(c);
  const auto found = std::ranges::find(check.findings, id, &DataFinding::id);
  if (found == check.findings.end()) throw std::logic_error("no finding " + std::string{id});
  return found->reveals;
}

TEST(DataCheck, ExcitationOfALog) {
  const DataCheck check = checkData(CaseTexts{}.read());
  const Excitation& e = check.logs[0].excitation;  // 0.5 sin(2 pi 0.5 t) for 3.184 s
  EXPECT_NEAR(e.duration_s, 3.184, 1e-9);
  EXPECT_NEAR(e.powered_s, 3.184, 1e-9);
  EXPECT_EQ(e.limp_s, 0);
  EXPECT_NEAR(e.position_rad.high, 0.5, 0.001);
  EXPECT_NEAR(e.speed_rad_s.greatest(), 0.5 * kPi, 0.04);
  EXPECT_EQ(e.reversals, 3);
  EXPECT_EQ(e.load_reversals, 3);
  EXPECT_THAT(e.payloads_kg, ElementsAre(0.3));
  EXPECT_THAT(e.p_registers, ElementsAre(32));
  EXPECT_NEAR(check.fit.session_s.high, 1.5 + 3.184, 1e-9);
  EXPECT_NEAR(check.held_out.duration_s, 3.184, 1e-9);  // held-out logs are not counted with the others
}

TEST(DataCheck, RestAndSlowMotion) {
  std::vector<CsvRow> rows = sineRows();
  for (std::size_t i = 0; i < rows.size(); ++i) {  // 1 s at rest, then 0.2 rad/s
    rows[i].pos = rounded(i < 63 ? 0 : 0.2 * (rows[i].t - 1.008), 2 * kPi / 4096);
    rows[i].goal = rows[i].pos;
    rows[i].speed = i < 63 ? 0 : 0.2;
  }
  const Case c = CaseTexts{}.with(rows).read();
  const Excitation e = checkData(c).logs[0].excitation;
  EXPECT_NEAR(e.at_rest_s, 1.0, 0.05);
  EXPECT_NEAR(e.slow_s, 2.18, 0.05);
  EXPECT_TRUE(reveals(c, "slow_motion"));
  EXPECT_FALSE(reveals(CaseTexts{}.read(), "slow_motion"));
}

TEST(DataCheck, LostRowsAndLateOnes) {
  std::vector<CsvRow> rows = sineRows(0.5, 0.5, 220);
  rows.erase(rows.begin() + 100, rows.begin() + 103);
  const LogCheck log = checkData(CaseTexts{}.with(rows).read()).logs[0];
  EXPECT_EQ(log.lost_rows, 3u);
  EXPECT_NEAR(log.period_s, 0.016, 1e-9);
  EXPECT_NEAR(log.late_s, 0, 1e-9);
  for (std::size_t i = 10; i < rows.size(); i += 20) rows[i].t += 0.006;  // one of twenty
  const DataCheck late = checkData(CaseTexts{}.with(rows).read());
  EXPECT_NEAR(late.logs[0].late_s, 0.006, 1e-9);
  EXPECT_EQ(late.logs[0].lost_rows, 3u);
  EXPECT_THAT(late.warnings, testing::Contains(HasSubstr("fit_1.csv: 3 ")));
}

TEST(DataCheck, ASlowerHostWithTorqueLosesNoRows) {
  std::vector<CsvRow> rows = sineRows(0.2, 0.3, 400);
  double t = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].on = i < 100 ? 1 : 0;
    rows[i].t = t += i < 100 ? 0.0105 : 0.0065;
    rows[i].load = 0;
    rows[i].speed = 0;
  }
  const DataCheck check = checkData(CaseTexts{}.with(rows).read());
  EXPECT_EQ(check.logs[0].lost_rows, 0u);
  EXPECT_TRUE(check.warnings.empty());
}

TEST(DataCheck, OnePayloadAndOneGainDoNotShowFriction) {
  const Case one = CaseTexts{}.read();
  EXPECT_FALSE(reveals(one, "payloads"));
  EXPECT_FALSE(reveals(one, "p_gains"));
  Case two = one;
  two.logs.push_back(two.logs[0]);
  two.logs.back().position_rad[0] += 0.001;
  two.logs.back().payload_kg = 0.35;
  two.logs.back().p_register = 16;
  EXPECT_TRUE(reveals(two, "payloads"));
  EXPECT_TRUE(reveals(two, "p_gains"));
  two.logs.back().payload_kg = 0.31;  // too close to distinguish
  EXPECT_FALSE(reveals(two, "payloads"));
  two.logs.back().payload_kg = 0.35;
  two.logs.back().held_out = true;  // what is kept is not learnt from
  EXPECT_FALSE(reveals(two, "payloads"));
}

TEST(DataCheck, TorqueOffForASecond) {
  Case c = CaseTexts{}.read();
  EXPECT_FALSE(reveals(c, "torque_off"));
  for (std::size_t i = 0; i < 62; ++i) c.logs[0].torque_on[i] = 0;
  EXPECT_FALSE(reveals(c, "torque_off"));
  for (std::size_t i = 0; i < 64; ++i) c.logs[0].torque_on[i] = 0;
  EXPECT_TRUE(reveals(c, "torque_off"));
}

TEST(DataCheck, ColumnsThatAreMissing) {
  Case c = CaseTexts{}.read();
  EXPECT_TRUE(reveals(c, "load_column"));
  c.logs[0].load.assign(c.logs[0].rows(), std::nan(""));
  EXPECT_FALSE(reveals(c, "load_column"));
  EXPECT_FALSE(reveals(c, "volt_column"));  // nobody knows whether it was under load
}

TEST(DataCheck, WarmthTimeAndSides) {
  Case c = CaseTexts{}.read();
  EXPECT_FALSE(reveals(c, "temperature"));
  c.logs[0].temp_c.back() = 34.9;
  EXPECT_FALSE(reveals(c, "temperature"));
  c.logs[0].temp_c.back() = 35;
  EXPECT_TRUE(reveals(c, "temperature"));
  EXPECT_FALSE(reveals(c, "session"));
  c.logs[0].time_s.back() += 30;
  EXPECT_TRUE(reveals(c, "session"));
  c.logs[0].is_session_known = false;
  EXPECT_FALSE(reveals(c, "session"));
  EXPECT_TRUE(reveals(c, "both_sides"));
  for (double& position : c.logs[0].position_rad) position = std::abs(position);
  EXPECT_FALSE(reveals(c, "both_sides"));
}

TEST(DataCheck, SaturationAndRepeatsAndHeldOutLogs) {
  Case c = CaseTexts{}.read();
  EXPECT_FALSE(reveals(c, "saturation"));
  for (std::size_t i = 10; i < 15; ++i) c.logs[0].load[i] = i % 2 == 0 ? -1 : 0.996;
  EXPECT_TRUE(reveals(c, "saturation"));
  EXPECT_FALSE(reveals(c, "repeats"));
  EXPECT_TRUE(reveals(c, "held_out_logs"));
  c.logs.pop_back();
  EXPECT_FALSE(reveals(c, "held_out_logs"));
}

TEST(DataCheck, HeldOutLogsThatLoadTheServoMore) {
  Case c = CaseTexts{}.read();
  for (Trajectory& log : c.logs) log.load.assign(log.rows(), 0.4);
  Trajectory& kept = c.logs.back();
  ASSERT_TRUE(kept.held_out);
  kept.load[10] = -0.48;
  EXPECT_TRUE(reveals(c, "held_out_load")) << "near enough";
  kept.load[10] = -0.52;
  EXPECT_FALSE(reveals(c, "held_out_load"));
  kept.torque_on[10] = 0;  // then it loads nothing
  EXPECT_TRUE(reveals(c, "held_out_load"));
  kept.torque_on[10] = 1;
  c.logs.front().load[10] = 0.5;
  EXPECT_TRUE(reveals(c, "held_out_load")) << "a fitted one goes as far";
  for (Trajectory& log : c.logs) log.load.assign(log.rows(), std::nan(""));
  EXPECT_TRUE(reveals(c, "held_out_load")) << "not measured";
}

TEST(DataCheck, NamesEffectsOfTheCatalogueOnly) {
  Case c = CaseTexts{}.read();
  c.logs.resize(1);
  for (const DataFinding& finding : checkData(c).findings)
    for (const std::string_view effect : finding.effects) EXPECT_NE(twin::findEffect(effect), nullptr) << effect;
}

TEST(DataCheck, AsText) {
  const DataCheck check = checkData(CaseTexts{}.read());
  const std::string text = asText(check);
  EXPECT_THAT(text, HasSubstr("fit_1.csv         3.2    0.0"));
  EXPECT_THAT(text, HasSubstr(messages::kCannotReveal));
  const auto found = std::ranges::find(check.findings, "repeats", &DataFinding::id);
  ASSERT_NE(found, check.findings.end());
  EXPECT_THAT(text, HasSubstr("  " + found->sentence + "\n    -> " + std::string{found->remedy} + "\n"));
}

}  // namespace
}  // namespace darwinop::gap
