// Logs that repeat another one, and copies that only look like it.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "gap/case/case_texts.hpp"
#include "gap/case/data_check.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"
#include "gap/case/repeat_spread.hpp"

namespace darwinop::gap {
namespace {

using testing::HasSubstr;

/// Three fit logs: fit_2 may repeat fit_1, fit_3 fit_2.
CaseTexts threeLogs(const std::string& of_2, const std::string& of_3, const std::string& kp_2 = "32") {
  CaseTexts texts;
  const std::size_t from = texts.json.find("\"logs\"");
  const auto entry = [](const std::string& name, const std::string& of, const std::string& kp) {
    return R"({"file": ")" + name + R"(", "role": "fit", "payload_kg": 0.3, "t0_session_s": 0, "kp": )" + kp +
           R"(, "repeat_of": )" + (of.empty() ? "null" : "\"" + of + "\"") + "}";
  };
  texts.json.replace(from, std::string::npos,
                     "\"logs\": [" + entry("fit_1.csv", "", "32") + "," + entry("fit_2.csv", of_2, kp_2) + "," +
                         entry("fit_3.csv", of_3, "32") + "]}");
  int seed = 0;
  for (const char* name : {"fit_1.csv", "fit_2.csv", "fit_3.csv"}) {
    std::vector<CsvRow> rows = sineRows();
    for (std::size_t i = static_cast<std::size_t>(seed); i < rows.size(); i += 5) rows[i].pos += 2 * kPi / 4096;
    texts.logs[name] = csvOf(rows);
    ++seed;
  }
  return texts;
}

TEST(CaseRepeats, LeadToTheFirstOfTheSeries) {
  const Case c = threeLogs("fit_1.csv", "fit_2.csv").read();
  EXPECT_EQ(c.logs[0].repeat_of, std::nullopt);
  EXPECT_EQ(c.logs[1].repeat_of, 0u);
  EXPECT_EQ(c.logs[2].repeat_of, 0u);
  EXPECT_TRUE(c.warnings.empty());
  EXPECT_TRUE(checkData(c).has_repeats);
}

/// Steps every second; CSVs of a raw folder name no motion.
Trajectory steps() {
  Trajectory log;
  log.length_m = 0.1, log.supply_v = 12;
  for (double t = 0; t < 6; t += 0.01) {
    log.time_s.push_back(t);
    log.goal_rad.push_back(std::fmod(t, 2) < 1 ? 0.5 : -0.5);
    log.torque_on.push_back(1);
  }
  return log;
}

TEST(CaseRepeats, AreKnownByTheirGoalsAndTheirBench) {
  const Trajectory log = steps();
  const auto is_repeat = [&](const std::function<void(Trajectory&)>& change) {
    Trajectory other = log;
    change(other);
    return isRepeat(log, other);
  };
  EXPECT_TRUE(is_repeat([](Trajectory& other) { other.kind = "run_2"; }));
  EXPECT_TRUE(is_repeat([](Trajectory& other) { other.time_s[99] += 0.007; })) << "a late row";
  EXPECT_TRUE(is_repeat([](Trajectory& other) { other.supply_v = 11.8; }));
  EXPECT_FALSE(is_repeat([](Trajectory& other) { other.supply_v = 7.4; }));
  EXPECT_FALSE(is_repeat([](Trajectory& other) { other.supply_v.reset(); }));
  EXPECT_FALSE(is_repeat([](Trajectory& other) { other.p_register = 16; }));
  EXPECT_FALSE(is_repeat([](Trajectory& other) { other.payload_kg = 0.2; }));
  EXPECT_FALSE(is_repeat([](Trajectory& other) { other.length_m = 0.2; }));
  EXPECT_FALSE(is_repeat([](Trajectory& other) { std::fill_n(other.torque_on.begin(), 200, 0); }));
  EXPECT_FALSE(is_repeat([](Trajectory& other) {
    for (std::size_t i = 0; i < other.rows(); ++i) other.goal_rad[i] = 0.5 * std::sin(4 * other.time_s[i]);
  }));
}

// Run by run 0, 3 and 6 mrad beside the first: their standard deviation is 3 mrad.
TEST(CaseRepeats, AllRunsCountInTheirSpread) {
  Case c = threeLogs("fit_1.csv", "fit_1.csv").read();
  for (std::size_t i = 0; i < c.logs.size(); ++i) {
    c.logs[i].position_rad = c.logs[0].position_rad;
    for (double& position : c.logs[i].position_rad) position += 0.003 * static_cast<double>(i);
  }
  EXPECT_NEAR(repeatSpread(c).rms_rad(), 0.003, 1e-9);
  c.logs[2].held_out = true;
  EXPECT_NEAR(repeatSpread(c).rms_rad(), 0.003, 1e-9) << "a held-out run as well";
  c.logs[2].position_rad[7] = std::nan("");
  EXPECT_NEAR(repeatSpread(c).rms_rad(), 0.003, 1e-9) << "a masked reading counts nowhere";
  EXPECT_EQ(checkData(c).repeats_rad, repeatSpread(c).rms_rad());
  for (Trajectory& log : c.logs) log.repeat_of.reset();
  EXPECT_TRUE(std::isnan(checkData(c).repeats_rad));
}

TEST(CaseRepeats, InACircleAreRefused) {
  EXPECT_THAT(threeLogs("fit_3.csv", "fit_2.csv").error(), HasSubstr("my/case.json: `logs[1].repeat_of` is circular"));
}

TEST(CaseRepeats, HaveTheSameGainAndGoals) {
  EXPECT_THAT(threeLogs("fit_1.csv", "", "16").error(), HasSubstr(messages::kOtherGainOrPayload));
  CaseTexts texts = threeLogs("fit_1.csv", "");
  texts.logs["fit_2.csv"] = csvOf(sineRows(0.53));
  EXPECT_EQ(texts.error(), "");  // 6 % away: clocks may differ by a row
  texts.logs["fit_2.csv"] = csvOf(sineRows(0.56));
  EXPECT_THAT(texts.error(), HasSubstr("`logs[1].repeat_of` names fit_1.csv, which has other goals"));
}

TEST(CaseRepeats, ACopyCountsOnceAndNotAsARepeat) {
  CaseTexts texts = threeLogs("fit_1.csv", "");
  const double before_s = checkData(texts.read()).fit.duration_s;
  texts.logs["fit_2.csv"] = texts.logs["fit_1.csv"];
  const Case c = texts.read();
  EXPECT_THAT(c.warnings, testing::ElementsAre(HasSubstr("my/fit_2.csv: has the same rows as fit_1.csv")));
  EXPECT_THAT(duplicates(c), testing::ElementsAre(std::nullopt, 0u, std::nullopt));
  const DataCheck check = checkData(c);
  EXPECT_EQ(check.logs[1].duplicate_of, 0u);
  EXPECT_FALSE(check.has_repeats);
  EXPECT_NEAR(check.fit.duration_s, before_s * 2 / 3, 1e-9);
}

}  // namespace
}  // namespace darwinop::gap
