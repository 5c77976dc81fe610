// The question of a plan follows from the verdict.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/text/nearest.hpp"
#include "gap/plan/messages.hpp"
#include "gap/plan/plan_rig.hpp"
#include "gap/plan/question.hpp"
#include "twin/model/sections.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const ProgressCallback kQuietly = [](const std::string&) {};

/// One log of steps: one payload, one gain, no torque off.
Case poorCase() {
  Case bench = smallBench();
  bench.logs = {commanded("steps", 2.1, 16, 0.3, [](double t) { return t < 0.4 ? 0.0 : t < 1.2 ? 0.9 : -0.4; })};
  bench.priors = {{"kt", 0.02}};
  return measured(bench, baselineOf(bench), 3);
}

std::vector<std::string> namesOf(const Question& question) {
  std::vector<std::string> names;
  for (const FittedHypothesis& one : question.hypotheses) names.push_back(one.name);
  return names;
}

std::string saidOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Question, WithNothingFoundIsWhatTheseLogsCannotShow) {
  const Question question = questionAfter(poorCase(), Identification{}, kQuietly);
  EXPECT_EQ(question.aim, Aim::kReveal);
  EXPECT_EQ(question.hypotheses.at(0).name, kNothing);
  EXPECT_THAT(namesOf(question), Contains("load_dependent_friction"));
  EXPECT_THAT(namesOf(question), Not(Contains("lost_packets")));
}

TEST(Question, OfCloseRivalsIsWhatSeparatesThem) {
  Identification identification;
  identification.effects.push_back({twin::findEffect("com_mass"), {}, 40});
  identification.rivals = {{{"encoder_offset"}, 3}, {{"accel_limit"}, 60}};
  const Question question = questionAfter(poorCase(), identification, kQuietly);
  EXPECT_EQ(question.aim, Aim::kSeparate);
  EXPECT_THAT(namesOf(question), testing::ElementsAre("com_mass", "encoder_offset"));
}

TEST(Question, OfAnEffectWithoutRivalsIsHowLargeItIs) {
  Identification identification;
  identification.effects.push_back({twin::findEffect("coulomb"), {}, 40});
  const Question question = questionAfter(poorCase(), identification, kQuietly);
  EXPECT_EQ(question.aim, Aim::kNarrow);
  EXPECT_EQ(question.hypotheses.at(0).unknowns.at(question.unknown).name, "coulomb.friction");
}

TEST(Question, ACopiedLogNarrowsNoInterval) {
  Case once = poorCase(), twice = once;
  twice.logs.push_back(twice.logs.front());
  twice.logs.back().file = "copy.csv";
  const Eigen::VectorXd sigmas = questionBetween(once, {"coulomb"}, kQuietly).hypotheses.at(1).sigmas();
  EXPECT_EQ(questionBetween(twice, {"coulomb"}, kQuietly).hypotheses.at(1).sigmas(), sigmas);
}

TEST(Question, RefusesUnknownEffects) {
  const Case given = poorCase();
  EXPECT_THAT(saidOf([&] {
                questionBetween(given, {"colomb", "viscous"}, kQuietly);
              }),
              HasSubstr("'colomb'; " + text::suggestion("colomb", twin::effectIds())));
  EXPECT_THAT(saidOf([&] { questionBetween(given, {"lost_packets"}, kQuietly); }),
              HasSubstr(std::string{"'lost_packets' "} + messages::kEffectNotFittable));
  EXPECT_THAT(saidOf([&] {
                questionBetween(given, {"viscous", "viscous"}, kQuietly);
              }),
              HasSubstr(messages::kEffectGivenTwice));
}

}  // namespace
}  // namespace darwinop::gap
