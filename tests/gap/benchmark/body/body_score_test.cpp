// The exam, against answers made by hand.
#include "gap/benchmark/score/body/body_score.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "gap/benchmark/score/body/body_case_table.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

BodyKey hiding(std::vector<BodyKeyEffect> effects) {
  BodyKey key;
  key.effects = std::move(effects);
  return key;
}

BodyAnswer naming(std::vector<BodyKeyEffect> effects) {
  BodyAnswer answer;
  answer.verdict = "named";
  answer.effects = std::move(effects);
  answer.runtime_s = 10;
  return answer;
}

BodyAnswer saying(const std::string& verdict, std::vector<std::string> where = {}) {
  BodyAnswer answer;
  answer.verdict = verdict, answer.where = std::move(where), answer.runtime_s = 10;
  return answer;
}

/// Right and counted cases of a figure.
std::pair<std::size_t, std::size_t> figure(const Score& score, const std::string& name) {
  for (const ShareFigure& one : score.shares)
    if (one.what == name) return {one.right, one.of};
  return {0, 0};
}

using Counted = std::pair<std::size_t, std::size_t>;

TEST(BodyScore, APlaceIsASetOfJoints) {
  const BodyKeyEffect pair{"backlash", {"KneeR", "KneeL"}, {}};
  const Score score = bodyScoreOf(
      {{"a", hiding({pair})}, {"b", hiding({pair})}},
      {{"a", naming({{"backlash", {"KneeL", "KneeR"}, {}}})}, {"b", naming({{"backlash", {"KneeR"}, {}}})}});
  EXPECT_EQ(figure(score, body_figures::kManyJoints), (Counted{2, 2}));
  EXPECT_EQ(figure(score, body_figures::kManyJointsPlace), (Counted{1, 2}));
  EXPECT_EQ(score.confusions.size(), 1U);
}

TEST(BodyScore, BusLatencyIsADelayOfAllJoints) {
  const Score score = bodyScoreOf({{"a", hiding({{"bus_latency", {"all"}, {{"delay", {0.01}}}}})}},
                                  {{"a", naming({{"transport_delay", {"all"}, {{"delay", {0.0105}}}}})}});
  EXPECT_EQ(figure(score, body_figures::kBus), (Counted{1, 1}));
  EXPECT_EQ(figure(score, body_figures::kBusNumber), (Counted{1, 1}));
}

TEST(BodyScore, NumbersCountWhereTheNameIsRight) {
  const BodyKey key = hiding({{"floor_tilt", {"floor"}, {{"tilt", {0.04, 0}}}}});
  const auto counted = [&](std::vector<double> tilt) {
    return figure(bodyScoreOf({{"a", key}}, {{"a", naming({{"floor_tilt", {"floor"}, {{"tilt", tilt}}}})}}),
                  body_figures::kContactNumber);
  };
  EXPECT_EQ(counted({0.045, 0.004}), (Counted{1, 1}));
  EXPECT_EQ(counted({0.045, 0.01}), (Counted{0, 1}));
  EXPECT_EQ(
      figure(bodyScoreOf({{"a", key}}, {{"a", naming({{"link_com", {"Body"}, {}}})}}), body_figures::kContactNumber),
      (Counted{0, 0}));
}

TEST(BodyScore, AShareOfAScaleIsOneOfItsDistanceFromOne) {
  const auto counted = [&](double scale) {
    return figure(bodyScoreOf({{"a", hiding({{"accel_scale", {"accelerometer"}, {{"scale", {1.06, 1, 1}}}}})}},
                              {{"a", naming({{"accel_scale", {"accelerometer"}, {{"scale", {scale, 1, 1}}}}})}}),
                  body_figures::kSensorNumber);
  };
  EXPECT_EQ(counted(1.062), (Counted{1, 1}));
  EXPECT_EQ(counted(1.05), (Counted{0, 1}));
  EXPECT_EQ(counted(1), (Counted{0, 1}));
}

TEST(BodyScore, TheFirstOfTwoIsRightInItsPlaceOnly) {
  const BodyKey key = hiding({{"coulomb", {"KneeR"}, {}}, {"gyro_bias", {"gyro"}, {}}});
  const auto counted = [&](const std::string& leg) {
    return figure(bodyScoreOf({{"a", key}}, {{"a", naming({{"coulomb", {leg}, {}}, {"gyro_bias", {"gyro"}, {}}})}}),
                  body_figures::kTwoFirst);
  };
  EXPECT_EQ(counted("KneeR"), (Counted{1, 1}));
  EXPECT_EQ(counted("KneeL"), (Counted{0, 1}));
}

TEST(BodyScore, ANumberIsRightAsAddedOrAsTotal) {
  const BodyKey key = hiding({{"link_mass", {"FootR"}, {{"mass_added", {0.1}}, {"mass_total", {0.3}}}}});
  for (const double value : {0.1, 0.3, 0.2})
    EXPECT_EQ(figure(bodyScoreOf({{"a", key}}, {{"a", naming({{"link_mass", {"FootR"}, {{"mass", {value}}}}})}}),
                     body_figures::kMassNumber),
              (Counted{value == 0.2 ? 0U : 1U, 1U}));
}

TEST(BodyScore, ADoubtOfThreeHasTheMass) {
  const BodyKey key = hiding({{"link_mass", {"Body"}, {}}});
  BodyAnswer answer = naming({{"link_com", {"Body"}, {}}});
  answer.verdict = "ambiguous";
  answer.ambiguity = {{{"link_com", {"Body"}}, {"link_mass", {"Body"}}}};
  EXPECT_EQ(figure(bodyScoreOf({{"a", key}}, {{"a", answer}}), body_figures::kMass), (Counted{1, 1}));
  answer.ambiguity[0].insert(answer.ambiguity[0].end(), {{"floor_tilt", {"floor"}}, {"sole_size", {"floor"}}});
  EXPECT_EQ(figure(bodyScoreOf({{"a", key}}, {{"a", answer}}), body_figures::kMass), (Counted{0, 1}));
}

TEST(BodyScore, UnknownIsAnAlarmWhereNothingIsHidden) {
  BodyKey wrong;
  wrong.is_exact = false;
  const Score score = bodyScoreOf({{"a", {}}, {"b", {}}, {"c", wrong}, {"d", {}}},
                                  {{"a", saying("none")}, {"b", saying("unknown")}, {"c", saying("cannot_tell")}});
  EXPECT_EQ(figure(score, body_figures::kExactAlarm), (Counted{2, 3}));  // or no answer
  EXPECT_EQ(figure(score, body_figures::kWrongAlarm), (Counted{0, 1}));
  EXPECT_EQ(score.unanswered, std::vector<std::string>{"d"});
}

TEST(BodyScore, OutsideOfTheCatalogueThePlaceIsThatOfAnOpenSignal) {
  BodyKey key = hiding({{"cable", {"Neck"}, {}}});
  key.is_outside = true, key.where = {"Neck"};
  const Score score = bodyScoreOf(
      {{"a", key}, {"b", key}},
      {{"a", saying("unknown", {"FootR.position", "Neck.position"})}, {"b", naming({{"coulomb", {"Neck"}, {}}})}});
  EXPECT_EQ(figure(score, body_figures::kOutside), (Counted{1, 2}));
  EXPECT_EQ(figure(score, body_figures::kOutsidePlace), (Counted{1, 2}));
}

/// Cases in the table that are marked as missed.
std::size_t missedIn(const std::string& table) {
  std::size_t count = 0;
  for (std::size_t at = table.find("| missed |"); at != std::string::npos; at = table.find("| missed |", at + 1))
    ++count;
  return count;
}

TEST(BodyScore, TheTableCountsAsTheExamDoes) {
  const BodyKeys keys{{"a", hiding({{"link_mass", {"Body"}, {}}})}};
  BodyAnswer answer = naming({{"link_mass", {"Body"}, {}}});
  EXPECT_EQ(missedIn(bodyCaseTable(keys, {{"a", answer}})), 0U);
  EXPECT_EQ(missedIn(bodyCaseTable(keys, {})), 1U) << "no answer";
  answer.runtime_s = kBodyTooLate + 1;
  EXPECT_EQ(bodyScoreOf(keys, {{"a", answer}}).fair.right, 0U);
  EXPECT_EQ(missedIn(bodyCaseTable(keys, {{"a", answer}})), 1U) << "a late one";
  EXPECT_THAT(bodyCaseTable(keys, {{"a", answer}}), testing::HasSubstr("link_mass Body")) << "what it was stays";
  BodyKey outside = hiding({{"cable", {"Neck"}, {}}});
  outside.is_outside = true;
  EXPECT_EQ(missedIn(bodyCaseTable({{"a", outside}}, {{"a", saying("error")}})), 1U);
}

TEST(BodyScore, AKeyIsReadAsItWasWritten) {
  const TemporaryFolder folder;
  BodyKey key = hiding({{"gyro_scale", {"gyro"}, {{"scale", {1, 1.1, 1}}}}, {"coulomb", {"FootR", "FootL"}, {}}});
  key.is_exact = false, key.gap_mrad = 3, key.noise_mrad = 0.6;
  writeBodyKeys({{"a", key}}, folder / "key.json");
  ASSERT_TRUE(isBodyKey(folder / "key.json"));
  const BodyKey read = readBodyKeys(folder / "key.json").at("a");
  ASSERT_EQ(read.effects.size(), 2U);
  EXPECT_EQ(read.effects[0].values, key.effects[0].values);
  EXPECT_EQ(read.effects[1].at, key.effects[1].at);
  EXPECT_FALSE(read.is_exact);
  EXPECT_DOUBLE_EQ(read.gap_mrad, 3);
}

}  // namespace
}  // namespace darwinop::gap
