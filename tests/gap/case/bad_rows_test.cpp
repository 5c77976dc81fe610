// Lone readings that no servo can have made are masked and counted; from a share on a log is refused.
#include "gap/case/bad_rows.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "gap/case/case_texts.hpp"
#include "gap/case/data_check.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Changes rows of fit_1.csv.
template <class Change>
CaseTexts changed(const Change& change, double amplitude_rad = 0.5, double hz = 0.5) {
  std::vector<CsvRow> rows = sineRows(amplitude_rad, hz);
  change(rows);
  const CaseTexts clean;  // CaseTexts{} in a template crashes gcc 12
  return clean.with(rows);
}

/// Column and number of the readings that are masked in fit_1.csv.
std::vector<std::pair<std::string, std::size_t>> maskedIn(const CaseTexts& texts) {
  std::vector<std::pair<std::string, std::size_t>> out;
  const Case c = texts.read();
  for (const MaskedReadings& masked : c.logs[0].masked) out.emplace_back(masked.column, masked.rows);
  return out;
}

using Masked = std::vector<std::pair<std::string, std::size_t>>;

TEST(BadRows, CleanLogsKeepEveryReading) {
  EXPECT_EQ(maskedIn(CaseTexts{}), Masked{});
  EXPECT_EQ(maskedIn(changed([](auto&) {}, 0.2, 3)), Masked{});
}

TEST(BadRows, ALonePositionIsMaskedAndItsNeighboursStay) {
  const CaseTexts texts = changed([](auto& rows) { rows[100].pos = -kPi; });
  EXPECT_EQ(maskedIn(texts), (Masked{{"pos", 1}}));
  const Trajectory log = texts.read().logs[0];
  EXPECT_TRUE(std::isnan(log.position_rad[100]));
  EXPECT_FALSE(std::isnan(log.position_rad[99]) || std::isnan(log.position_rad[101]));
  EXPECT_EQ(log.masked[0].first_line, 102u);
}

TEST(BadRows, AJumpThatAnAccelerationCannotMakeIsMasked) {
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].pos += 0.1; })), (Masked{{"pos", 1}}));
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].pos += 0.01; })), Masked{});
}

TEST(BadRows, ALoadThatJumpsAndComesBackIsMaskedWhereTheGoalStays) {
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].load = -100; })), (Masked{{"load", 1}}));
  const auto goal_moves = [](auto& rows) { rows[99].goal += 0.2, rows[100].load += 100; };
  EXPECT_EQ(maskedIn(changed(goal_moves, 0.1)), Masked{}) << "a command of one row";
  const auto longer = [](auto& rows) {
    for (int i = 100; i < 103; ++i) rows[i].load = -100;
  };
  EXPECT_EQ(maskedIn(changed(longer, 0.1)), Masked{}) << "three rows are an event";
}

TEST(BadRows, ARunOfFalsePositionsIsMaskedAlsoAtTheBegin) {
  EXPECT_EQ(maskedIn(changed([](auto& rows) {
              for (int i = 100; i < 104; ++i) rows[i].pos = -kPi;
            })),
            (Masked{{"pos", 4}}));
  const CaseTexts at_begin = changed([](auto& rows) { rows[0].pos = rows[1].pos = -kPi; });
  EXPECT_EQ(maskedIn(at_begin), (Masked{{"pos", 2}}));
}

TEST(BadRows, EveryColumnHasItsBounds) {
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].volt = 0; })), (Masked{{"volt", 1}}));
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].volt = 8.5; })), Masked{});  // a long thin cable
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].volt = 7; })), (Masked{{"volt", 1}}));
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].volt = 24; })), (Masked{{"volt", 1}}));
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].temp = 150; })), (Masked{{"temp", 1}}));
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].temp = 38; })), (Masked{{"temp", 1}}));
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].temp = 31; })), Masked{});
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].load = 150; })), (Masked{{"load", 1}}));
  EXPECT_EQ(maskedIn(changed([](auto& rows) { rows[100].speed = 60; })), (Masked{{"speed", 1}}));
}

TEST(BadRows, AnOldAnswerReadAgainIsMaskedInAllColumns) {
  const auto repeat = [](auto& rows) {
    const CsvRow old = rows[39];
    rows[40] = {rows[40].t, rows[40].goal, 1, old.pos, old.speed, old.load, old.volt, old.temp};
  };
  EXPECT_EQ(maskedIn(changed(repeat, 0.5, 0.8)),
            (Masked{{"pos", 1}, {"speed", 1}, {"load", 1}, {"volt", 1}, {"temp", 1}}));
}

TEST(BadRows, AnEmptyPositionCounts) {
  CaseTexts texts;
  std::string& log = texts.logs["fit_1.csv"];
  const std::size_t from = log.find("\n1.6,") + 1;
  log.replace(from, log.find('\n', from) - from, "1.6,0,1,,0,0,12,30");
  EXPECT_EQ(maskedIn(texts), (Masked{{"pos", 1}}));
}

TEST(BadRows, AReadingThatIsMaskedAlreadyIsNotCountedAgain) {
  const auto repeat = [](auto& rows) {
    rows[39].temp = 150;
    for (const std::size_t row : {std::size_t{40}, std::size_t{79}}) {
      const CsvRow old = rows[row - 1];
      rows[row] = {rows[row].t, rows[row].goal, 1, old.pos, old.speed, old.load, old.volt, old.temp};
    }
  };
  EXPECT_EQ(maskedIn(changed(repeat, 0.5, 0.8)),
            (Masked{{"temp", 2}, {"pos", 2}, {"speed", 2}, {"load", 2}, {"volt", 2}, {"temp", 1}}));
}

TEST(BadRows, ChecksThatMaskFewEachMayMaskTooManyTogether) {
  const auto with = [](std::size_t bad) {
    return changed([&](auto& rows) {
             for (std::size_t i = 0; i < bad; ++i) rows[3 + 9 * i].volt = i % 2 == 0 ? 0 : 7;
           })
        .error();
  };
  EXPECT_EQ(with(20), "");  // 10 %
  EXPECT_THAT(with(21), AllOf(HasSubstr("my/fit_1.csv: volt"), HasSubstr(messages::kManyMasked),
                              HasSubstr("21 of 200 rows (10.5 %)")));
}

TEST(BadRows, EmptyAndFalsePositionsCountTogether) {
  const auto with = [](std::size_t empty) {
    CaseTexts texts = changed([](auto& rows) {
      for (std::size_t i = 0; i < 15; ++i) rows[3 + 13 * i].pos = -kPi;
    });
    std::vector<CsvRow> rows = sineRows();
    std::string& log = texts.logs["fit_1.csv"];
    for (std::size_t i = 0; i < empty; ++i) {
      const std::string line = csvOf({rows[10 + 13 * i]}, "");  // "\nt,goal,on,pos,..."
      std::size_t from = 0;
      for (int comma = 0; comma < 3; ++comma) from = line.find(',', from) + 1;
      log = replaced(log, line, std::string{line}.erase(from, line.find(',', from) - from));
    }
    return texts.error();
  };
  EXPECT_EQ(with(5), "");
  EXPECT_THAT(with(6), AllOf(HasSubstr("my/fit_1.csv: pos"), HasSubstr(messages::kManyMasked)));
}

TEST(BadRows, ASparseColumnMayBeEmptyInMostRows) {
  CaseTexts texts = changed([](auto& rows) { rows[100].volt = 0; });
  std::string& log = texts.logs["fit_1.csv"];
  for (std::size_t from = log.find(",12,30\n"); from != std::string::npos; from = log.find(",12,30\n", from + 60))
    log.replace(from, 4, ",,");
  EXPECT_EQ(maskedIn(texts), (Masked{{"volt", 1}}));
}

TEST(BadRows, TheSupplyOfTheLogBoundsItsSpeeds) {
  // Without load 6.7 rad/s at 12 V, 13.3 at 24 V; an arm of 1 m falls at 6.3.
  const CaseTexts at_12 =
      changed([](auto& rows) { rows[100].speed = 20; }).with("\"length_m\": 0.17", "\"length_m\": 1");
  EXPECT_EQ(maskedIn(at_12), (Masked{{"speed", 1}}));
  EXPECT_EQ(maskedIn(at_12.with("\"payload_kg\": 0.3", "\"payload_kg\": 0.3, \"supply_V\": 24")), Masked{});
}

TEST(BadRows, FromAShareOnALogIsRefused) {
  const auto with = [](std::size_t bad) {
    return changed([&](auto& rows) {
             for (std::size_t i = 0; i < bad; ++i) rows[3 + 9 * i].volt = 0;
           })
        .error();
  };
  EXPECT_EQ(with(20), "");  // 10 %
  EXPECT_THAT(with(21), HasSubstr("21 of 200 rows"));
}

TEST(BadRows, AMessageGuessesAUnitOnlyIfTheWholeColumnFits) {
  const auto with = [](double load, double other) {
    return changed([&](auto& rows) {
             for (std::size_t i = 0; i < 60; ++i) rows[i].load = load;
             rows[100].load = other;
           })
        .error();
  };
  EXPECT_THAT(with(1023, 0), HasSubstr(messages::kRawCounts));
  EXPECT_THAT(with(1023, 60000), Not(HasSubstr(messages::kRawCounts)));
}

TEST(BadRows, TheCheckOfTheDataCountsThem) {
  const Case c = changed([](auto& rows) { rows[100].pos = -kPi; }).read();
  const std::string text = asText(checkData(c));
  EXPECT_THAT(text, HasSubstr(messages::kMaskedReadings));
  EXPECT_THAT(text, HasSubstr(asSentence(c.logs[0], c.logs[0].masked[0])));
}

}  // namespace
}  // namespace darwinop::gap
