// Numbers of the model that the logs contradict.
#include "gap/case/contradictions.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "gap/case/case_texts.hpp"
#include "gap/case/data_check.hpp"

namespace darwinop::gap {
namespace {

TEST(Contradictions, NumbersOfTheModelThatTheLogsContradict) {
  EXPECT_THAT(contradictionsOf(CaseTexts{}.read()), testing::IsEmpty());
  EXPECT_THAT(contradictionsOf(CaseTexts{}.with("\"supply_V\": 12.0", "\"supply_V\": 12.5").read()),
              testing::IsEmpty());
  const Case c = CaseTexts{}.with("\"supply_V\": 12.0", "\"supply_V\": 15").read();
  const std::vector<Contradiction> found = contradictionsOf(c);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].number, "supply_V");
  EXPECT_EQ(found[0].model, 15);
  EXPECT_EQ(found[0].measured, 12);
  EXPECT_EQ(found[0].logs, 2u);
  EXPECT_THAT(asText(checkData(c)), testing::HasSubstr(asSentence(found[0])));
  // Each log against its own bench.
  const CaseTexts own = CaseTexts{}.with("\"payload_kg\": 0.3", "\"payload_kg\": 0.3, \"supply_V\": 10");
  ASSERT_EQ(contradictionsOf(own.read()).size(), 1u);
  EXPECT_EQ(contradictionsOf(own.read())[0].logs, 1u);
  // A voltage that drops under load alone is a sag.
  std::vector<CsvRow> rows = sineRows(1.2);
  for (CsvRow& row : rows) row.volt = std::abs(row.load) < 5 ? 12 : 10;
  EXPECT_THAT(contradictionsOf(CaseTexts{}.with(rows).read()), testing::IsEmpty());
}

TEST(Contradictions, ALoadBeyondTheGreatestDuty) {
  std::vector<CsvRow> rows = sineRows();
  for (std::size_t i = 50; i < 60; ++i) rows[i].load = 90;
  const std::vector<Contradiction> found =
      contradictionsOf(CaseTexts{}.with("\"duty_max\": 1.0", "\"duty_max\": 0.8").with(rows).read());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].number, "duty_max");
  EXPECT_NEAR(found[0].measured, 0.9, 1e-9);
}

/// A sine, half a second at its last angle, then the arm falls to `rest_rad` and stays there. `zero_rad`: where the
/// bench counts from.
std::vector<CsvRow> releasedRows(double rest_rad, double zero_rad = 0) {
  std::vector<CsvRow> rows = sineRows();
  const double from = rows[100].pos;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CsvRow& row = rows[i];
    if (i >= 100) {
      const double share = std::clamp((static_cast<double>(i) - 130) / 30, 0.0, 1.0);
      row.on = i < 130, row.goal = from, row.load = 0, row.pos = from + share * (rest_rad - from);
      row.speed = share > 0 && share < 1 ? (rest_rad - from) / 0.48 : 0;
    }
    row.goal += zero_rad, row.pos += zero_rad;
  }
  return rows;
}

// A bench whose zero points up has gravity with the wrong sign.
TEST(Contradictions, AnArmThatRestsElsewhereThanItHangs) {
  const std::vector<Contradiction> found = contradictionsOf(CaseTexts{}.with(releasedRows(0, kPi - 0.01)).read());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].number, kRestAngle);
  EXPECT_NEAR(found[0].measured, kPi - 0.01, 0.02);
  EXPECT_THAT(contradictionsOf(CaseTexts{}.with(releasedRows(0.3)).read()), testing::IsEmpty()) << "dry friction";
}

}  // namespace
}  // namespace darwinop::gap
