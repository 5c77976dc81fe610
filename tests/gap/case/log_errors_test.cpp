// Impossible values: just inside passes, just outside is refused with file and line.
#include <gmock/gmock.h>

#include "experiments/logs/read_log.hpp"
#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// fit_1.csv with one value changed in row 100, line 102.
std::string errorWith(double CsvRow::*member, double value) {
  std::vector<CsvRow> rows = sineRows();
  rows[100].*member = value;
  return CaseTexts{}.with(rows).error();
}

/// The same in all rows from there on.
std::string errorFrom102With(double CsvRow::*member, double value) {
  std::vector<CsvRow> rows = sineRows();
  for (std::size_t i = 100; i < rows.size(); ++i) rows[i].*member = value;
  return CaseTexts{}.with(rows).error();
}

auto inLine102(const std::string& says) {
  return AllOf(StartsWith("my/fit_1.csv, line 102: "), HasSubstr(says));
}

/// Answer for a log with these two values in each row.
std::string errorOfSchedule(const std::string& columns, const std::string& values) {
  std::string text = csvOf(sineRows());
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    const std::string& more = at < 100 ? columns : values;
    text.insert(at, more);
    at += more.size();
  }
  CaseTexts texts;
  texts.logs["fit_1.csv"] = text;
  return texts.error();
}

TEST(LogErrors, AReadFollowsItsWrite) {
  EXPECT_EQ(errorOfSchedule(",written_s,read_s", ",0.0007,0.0017"), "");
  EXPECT_THAT(errorOfSchedule(",written_s,read_s", ",0.0017,0.0007"), HasSubstr(messages::kScheduleOrder));
  EXPECT_THAT(errorOfSchedule(",written_s,read_s", ",,0.0007"), HasSubstr(messages::kScheduleOrder));
  EXPECT_THAT(errorOfSchedule(",read_s", ",0.0007"), HasSubstr(messages::kHalfSchedule));
}

TEST(LogErrors, RangesOfTheColumns) {
  EXPECT_EQ(errorFrom102With(&CsvRow::load, 101), "");
  EXPECT_THAT(errorFrom102With(&CsvRow::load, 103.2), inLine102("load is 103.2 %"));
  EXPECT_EQ(errorFrom102With(&CsvRow::volt, 3), "");
  EXPECT_THAT(errorFrom102With(&CsvRow::volt, 2.9), inLine102("volt is 2.9 V"));
  EXPECT_EQ(errorFrom102With(&CsvRow::volt, 30), "");
  EXPECT_THAT(errorFrom102With(&CsvRow::volt, 120), inLine102("volt is 120 V"));
  EXPECT_EQ(errorFrom102With(&CsvRow::temp, -20), "");
  EXPECT_THAT(errorFrom102With(&CsvRow::temp, -21), inLine102("temp is -21 degC"));
  EXPECT_EQ(errorFrom102With(&CsvRow::temp, 100), "");
  EXPECT_THAT(errorFrom102With(&CsvRow::temp, 101), inLine102("temp is 101 degC"));
  EXPECT_EQ(errorWith(&CsvRow::goal, 12.5), "");  // two turns are 12.57
  EXPECT_THAT(errorWith(&CsvRow::goal, 12.6), inLine102("goal is 12.6 rad"));
  EXPECT_THAT(errorFrom102With(&CsvRow::speed, 101), inLine102("speed is 101 rad/s"));
  EXPECT_THAT(errorWith(&CsvRow::on, 2), inLine102("torque_on is 2"));
}

TEST(LogErrors, TimeThatDoesNotGoOn) {
  EXPECT_EQ(errorWith(&CsvRow::t, 0.016 * 99 + 0.001), "");
  EXPECT_THAT(errorWith(&CsvRow::t, 0.016 * 99), inLine102(logs::kTimeGoesBack));
}

TEST(LogErrors, HolesInTime) {
  const auto with_hole = [](double periods, double period_s) {
    std::vector<CsvRow> rows = sineRows(0.02);
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i].t = period_s * (static_cast<double>(i) + (i < 100 ? 0 : periods - 1));
    return CaseTexts{}.with(rows).error();
  };
  EXPECT_EQ(with_hole(19.9, 0.032), "");
  EXPECT_THAT(with_hole(20.1, 0.032), inLine102("the log has a hole of 0.6432 s before this row"));
  EXPECT_EQ(with_hole(49, 0.01), "") << "a pause of the host";
  EXPECT_THAT(with_hole(51, 0.01), inLine102("the log has a hole of 0.51 s before this row"));
}

TEST(LogErrors, TooShortAndTooSlow) {
  EXPECT_EQ(CaseTexts{}.with(sineRows(0.5, 0.5, 126)).error(), "");  // 2 s
  EXPECT_THAT(CaseTexts{}.with(sineRows(0.5, 0.5, 125)).error(), StartsWith("my/fit_1.csv: 1.984 s of data"));
  const auto stretched = [](double period) {
    std::vector<CsvRow> rows = sineRows();
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].t = period * double(i), rows[i].speed = 0.001;
    return CaseTexts{}.with(rows).error();
  };
  EXPECT_EQ(stretched(0.0999), "");
  EXPECT_THAT(stretched(0.101), HasSubstr("a row every 0.101 s"));
}

TEST(LogErrors, EmptyAndInfiniteFields) {
  const auto with = [](const std::string& line) {
    CaseTexts texts;
    std::string& log = texts.logs["fit_1.csv"];
    const std::size_t from = log.find("\n1.6,") + 1;  // row 100
    log.replace(from, log.find('\n', from) - from, line);
    return texts.error();
  };
  EXPECT_EQ(with("1.6,0,1,0,0,0,12,30"), "");
  EXPECT_EQ(with("1.6,0,1,0,,,,"), "");  // not known, and not needed
  EXPECT_THAT(with("1.6,,1,0,0,0,12,30"), inLine102("goal_rad is empty"));
  EXPECT_THAT(with("1.6,0,,0,0,0,12,30"), inLine102("torque_on is empty"));
  EXPECT_EQ(with("1.6,0,1,nan,0,0,12,30"), "");
  EXPECT_THAT(with("1.6,0,1,0,0,0,inf,30"), inLine102("volt_V is infinite"));
  EXPECT_THAT(with("1.6,0,1,0,0,0,12"), inLine102("7 fields"));
}

TEST(LogErrors, ColumnsAndTheirUnits) {
  const auto named = [](const std::string& what, const std::string& by) {
    CaseTexts texts;
    texts.logs["fit_1.csv"] = replaced(texts.logs["fit_1.csv"], what, by);
    return texts.error();
  };
  EXPECT_EQ(named("volt_V", "other"), "");
  EXPECT_THAT(named("pos_rad", "angle_rad"), StartsWith("my/fit_1.csv: no column pos_rad"));
  EXPECT_THAT(named("torque_on", "on"), StartsWith("my/fit_1.csv: no column torque_on"));
  EXPECT_THAT(named("pos_rad", "pos_grad"),
              HasSubstr("unit of column \"pos_grad\" is not known; it has to be rad or deg"));
  EXPECT_THAT(named("pos_rad", "pos"), HasSubstr("unit of column \"pos\" is not known"));
  EXPECT_THAT(named("volt_V", "volt_A"), HasSubstr("unit of column \"volt_A\" is A; it has to be V"));
  EXPECT_THAT(named("volt_V", "pos_deg"), HasSubstr("both contain the pos"));
}

TEST(LogErrors, ASensorThatNeverMoves) {
  const auto stuck = [](double goals, double on) {
    std::vector<CsvRow> rows = sineRows(goals, 0.5);
    for (CsvRow& row : rows) row.pos = 0.3, row.on = on, row.speed = 0, row.load = 5;
    return CaseTexts{}.with(rows).error();
  };
  EXPECT_EQ(stuck(0.02, 1), "");  // a servo with friction may stay for so little
  EXPECT_EQ(stuck(0.5, 0), "");   // limp: goals move nothing
  EXPECT_THAT(stuck(0.5, 1), StartsWith("my/fit_1.csv, line 2: pos never changes"));
}

/// Stands for a second from row 50 on, while the load goes from one value to another.
std::string errorOfAStandstill(double from_pct, double to_pct, double speed) {
  std::vector<CsvRow> rows = sineRows(0.1);
  for (std::size_t i = 50; i < 113; ++i) {
    rows[i].pos = rows[50].pos;
    rows[i].load = from_pct + (to_pct - from_pct) * double(i - 50) / 63;
    rows[i].speed = speed;
  }
  return CaseTexts{}.with(rows).error();
}

TEST(LogErrors, ASensorThatStopsForAWhile) {
  EXPECT_EQ(errorOfAStandstill(-10, -90, 0), "");  // friction, and a push one way
  EXPECT_EQ(errorOfAStandstill(-35, 90, 0), "");
  const std::string both = errorOfAStandstill(-45, 90, 0);
  EXPECT_THAT(both, AllOf(StartsWith("my/fit_1.csv, line "), HasSubstr(messages::kStuckDespiteLoad)));
  EXPECT_EQ(errorOfAStandstill(0, 10, 0.15), "");
  EXPECT_THAT(errorOfAStandstill(0, 10, 0.25), HasSubstr(messages::kStuckDespiteSpeed));
}

TEST(LogErrors, OldReadingsLoggedAgain) {
  const auto with_goals = [](double amplitude) {
    std::vector<CsvRow> rows = sineRows(0.05);
    for (std::size_t i = 50; i < 175; ++i) {
      rows[i] = {rows[i].t, amplitude * std::sin(2 * kPi * (rows[i].t - 0.8)), 1, rows[50].pos, 0, 3, 12, 30};
    }
    return CaseTexts{}.with(rows).error();
  };
  EXPECT_EQ(with_goals(0.02), "");  // the law asks for 10 % of duty each way
  EXPECT_THAT(with_goals(0.3), HasSubstr(messages::kStuckLikeLoad));
}

}  // namespace
}  // namespace darwinop::gap
