// What a terminal shows, and the figures behind it.
#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "gap/report/html.hpp"
#include "gap/report/report_rig.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> linesOfText(const std::string& text) {
  std::istringstream stream{text};
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Without line ends: where a terminal breaks a sentence does not matter here.
std::string inOneLine(std::string text) {
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}

TEST(Summary, HasPlaceEffectIntervalAndImprovement) {
  const ReportRig rig;
  const std::string text = inOneLine(asText(rig.report));
  EXPECT_THAT(text, HasSubstr("The model lacks dry friction: friction 0.0423 N m, with nine chances in ten between "
                              "0.0401 and"));
  EXPECT_THAT(text, HasSubstr("falls from 31.0 mrad to 0.93 mrad; noise alone makes 0.89."));
  EXPECT_THAT(text, HasSubstr("coulomb.friction = 0.0423 N m   (90 %: 0.0401 to 0.0447 N m), gain 312"));
  EXPECT_THAT(text, HasSubstr("deadband instead: worse by 45"));
  EXPECT_THAT(text, HasSubstr("length has to be 1.034 times what was given: 3.4 sigma"));
  EXPECT_THAT(text, HasSubstr("loop: the plant"));
}

TEST(Summary, SaysWhyAnEffectThatFitsIsNotNamed) {
  ReportRig rig;
  Identification& identification = rig.outcome.identification;
  identification.remains = true;
  identification.prior_conflicts.clear();
  identification.rejected = {{twin::findEffect("supply_sag"), RejectionReason::kVoltage},
                             {twin::findEffect("torque_limit"), RejectionReason::kUndecided},
                             {twin::findEffect("cogging"), RejectionReason::kWorsensHeldOut}};
  rig.make();
  const std::string text = inOneLine(asText(rig.report));
  EXPECT_THAT(text, HasSubstr("supply_sag: " + std::string{messages::kVoltage}));
  EXPECT_THAT(text, HasSubstr("torque_limit: " + std::string{messages::kUndecided}));
  EXPECT_THAT(text, HasSubstr(messages::kRemainder));
  const nlohmann::json answer = asJson(rig.given, rig.outcome);
  EXPECT_EQ(answer["rejected"][0]["why"], "voltage");
  EXPECT_EQ(answer["rejected"][1]["id"], "torque_limit");
  EXPECT_EQ(answer["rejected"][2]["why"], "worsens_held_out");
  EXPECT_THAT(rejectionSentence(identification.rejected[2]), HasSubstr(messages::kWorsensHeldOutInFull));
  EXPECT_THAT(rejectionSentence(identification.rejected[1]),
              HasSubstr(twin::findEffect("quadratic_load_friction")->title));
  EXPECT_THAT(rejectionSentence(identification.rejected[1]), HasSubstr(twin::findEffect("torque_limit")->separated_by));
}

TEST(Summary, SaysWhatARemainderDoesToTheIntervals) {
  ReportRig rig;
  Identification& identification = rig.outcome.identification;
  EXPECT_THAT(inOneLine(asText(rig.report)), Not(HasSubstr(messages::kWidened)));
  identification.remains = true;
  EXPECT_THAT(inOneLine(asText(rig.report)), HasSubstr(messages::kWidened));
  EXPECT_THAT(asHtml(rig.report), HasSubstr(messages::kWidened));
  identification.explained = {"fit_1.csv", "fit_2.csv"};
  EXPECT_THAT(inOneLine(asText(rig.report)), HasSubstr(std::string{messages::kExplained} + "fit_1.csv, fit_2.csv."));
  EXPECT_EQ(asJson(rig.given, rig.outcome)["explained_logs"].size(), 2U);
  identification.verdict = Verdict::kAmbiguous;
  identification.rivals.front().behind = 1;
  EXPECT_THAT(inOneLine(asText(rig.report)), HasSubstr(messages::kRemainder)) << "beside an ambiguous set as well";
}

TEST(Summary, SaysWhenGoalsWereWrittenWhereTheFitHadToFindIt) {
  ReportRig rig;
  EXPECT_THAT(asText(rig.report), Not(HasSubstr("written")));
  EXPECT_FALSE(asJson(rig.given, rig.outcome)["bench"].contains("written_before_s"));
  rig.given.goal_order = GoalOrder::kBeforeRead;
  rig.outcome.identification.model = baselineOf(rig.given);
  EXPECT_THAT(asText(rig.report), Not(HasSubstr("written"))) << "the middle of a row, as nothing else was fitted";
  rig.outcome.identification.model.written_before_s = 0.00257;
  for (const std::string& text : {inOneLine(asText(rig.report)), asHtml(rig.report)})
    EXPECT_THAT(text, HasSubstr("written 2.6 ms before the read"));
  EXPECT_EQ(asJson(rig.given, rig.outcome)["bench"]["written_before_s"], 0.00257);
}

TEST(Summary, NamesTheExperimentForEachEffectThatIsUndecided) {
  ReportRig rig;
  Identification& identification = rig.outcome.identification;
  identification.verdict = Verdict::kAmbiguous;
  identification.rivals = {{{"coulomb", "torque_limit"}, 0}, {{"coulomb", "backlash"}, 3}, {{"deadband"}, 45}};
  const auto separation = [](const char* id) { return std::string{twin::findEffect(id)->separated_by}; };
  const auto beginning = [&](const char* id) { return separation(id).substr(0, 40); };  // the rest goes on below
  std::string text = inOneLine(asText(rig.report));
  EXPECT_THAT(text, HasSubstr(messages::kPerhaps + std::string{twin::findEffect("torque_limit")->title}));
  EXPECT_THAT(text, HasSubstr("torque_limit as well"));
  for (const char* const id : {"torque_limit", "backlash"}) {
    EXPECT_THAT(text, HasSubstr(beginning(id)));
    EXPECT_THAT(asHtml(rig.report), HasSubstr(html::text(separation(id))));
  }
  EXPECT_THAT(text, Not(HasSubstr(beginning("coulomb")))) << "it is in every set";
  EXPECT_THAT(text, Not(HasSubstr(beginning("deadband")))) << "it is excluded";
  EXPECT_EQ(asJson(rig.given, rig.outcome)["ambiguity"][0], nlohmann::json({"torque_limit", "backlash"}));
  identification.rivals = {{{"deadband"}, 2}};
  text = inOneLine(asText(rig.report));
  EXPECT_THAT(text, HasSubstr(messages::kNotIdentified));
  EXPECT_EQ(asJson(rig.given, rig.outcome)["ambiguity"][0], nlohmann::json({"coulomb", "deadband"}));
  identification.threshold = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(inOneLine(asText(rig.report)), HasSubstr(std::string{"deadband instead: "} + messages::kPredictsAsWell));
  EXPECT_THAT(asHtml(rig.report), HasSubstr(std::string{"</code> instead: "} + messages::kPredictsAsWell));
  identification.rivals = {{{"coulomb", "torque_limit"}, 0}};
  EXPECT_THAT(inOneLine(asText(rig.report)),
              HasSubstr(std::string{"torque_limit as well: "} + messages::kMayPredictBetter));
}

TEST(Summary, ListsWhatWasTriedThoughNothingIsNamed) {
  ReportRig rig;
  Identification& identification = rig.outcome.identification;
  identification.verdict = Verdict::kUnknown;
  nlohmann::json answer = asJson(rig.given, rig.outcome);
  EXPECT_TRUE(answer["effects"].empty());
  ASSERT_EQ(answer["candidates"].size(), 1U) << "it improves the fit";
  EXPECT_EQ(answer["candidates"][0]["id"], "coulomb");
  identification.withdrawn = std::exchange(identification.effects, {});
  identification.model = rig.outcome.baseline;
  identification.rejected = {{twin::findEffect("cogging"), RejectionReason::kSmallShare}};
  identification.prior_conflicts.clear();
  rig.make();
  answer = asJson(rig.given, rig.outcome);
  ASSERT_EQ(answer["candidates"].size(), 1U) << "it was withdrawn";
  EXPECT_EQ(answer["rejected"][0]["why"], "small_share");
  const std::string text = inOneLine(asText(rig.report)), page = asHtml(rig.report);
  EXPECT_THAT(text, HasSubstr(std::string{messages::kTried} + "coulomb.friction = 0.0423 N m."));
  EXPECT_THAT(text, HasSubstr(std::string{"cogging: "} + messages::kSmallShare));
  EXPECT_THAT(page, AllOf(HasSubstr(messages::kTried), HasSubstr(messages::kSmallShareInFull)));
}

TEST(Results, HaveTheBlockOfTheNamedEffectAndTheFirstOpenBlock) {
  const Case given = twoLogs();
  Outcome outcome = dryFriction(given);
  outcome.localization.blocks.first = Block::kController;
  EXPECT_EQ(asJson(given, outcome)["block"], "plant");
  EXPECT_EQ(asJson(given, outcome)["first_open_block"], "controller");
  outcome.identification.effects.front().effect = twin::findEffect("deadband");
  outcome.localization.blocks.first.reset();
  EXPECT_EQ(asJson(given, outcome)["block"], "controller");
  EXPECT_TRUE(asJson(given, outcome)["first_open_block"].is_null());
  outcome.localization.blocks.first = Block::kSensor;
  outcome.identification.verdict = Verdict::kUnknown;
  EXPECT_EQ(asJson(given, outcome)["block"], "sensor");
}

TEST(Summary, FitsAScreenHoweverMuchWasFound) {
  ReportRig rig;
  Identification& identification = rig.outcome.identification;
  identification.verdict = Verdict::kAmbiguous;
  for (const char* id : {"stribeck", "backlash", "supply_sag"})
    identification.effects.push_back(
        {twin::findEffect(id),
         {{std::string{id} + ".one", "N m", 0.1, 0.09, 0.11}, {std::string{id} + ".two", "", 1, 0, 2}},
         100});
  identification.rivals.assign(9, {{"deadband", "load_dependent_friction", "directional_load_friction"}, 5});
  identification.prior_conflicts.assign(9, {"duty_per_kp", 3.3, 1.2});
  rig.make();
  const std::vector<std::string> lines = linesOfText(asText(rig.report));
  EXPECT_LE(lines.size(), 30U);
  for (const std::string& line : lines) EXPECT_LE(line.size(), 100U) << line;
}

TEST(Summary, HasTheNumbersThatTheFitMoved) {
  ReportRig rig;
  twin::ServoParameters& servo = rig.outcome.identification.model.servo;
  servo = rig.outcome.baseline.servo;
  rig.make();
  EXPECT_THAT(asText(rig.report), Not(HasSubstr("numbers ")));
  servo.kt_nm_a = servo.back_emf_vs_rad = 2 * rig.outcome.baseline.servo.kt_nm_a;
  servo.resistance_ohm *= 1.001;
  rig.make();
  EXPECT_THAT(asText(rig.report), HasSubstr("numbers   kt = 3.572 N m/A (given: 1.786)\n"));
}

TEST(Summary, ContinuesALongLineBelowItself) {
  ReportRig rig;
  Identification& identification = rig.outcome.identification;
  identification.verdict = Verdict::kAmbiguous;
  identification.rivals.assign(
      1,
      {{"deadband", "load_dependent_friction", "directional_load_friction", "backlash", "quadratic_load_friction"}, 5});
  rig.make();
  EXPECT_THAT(asText(rig.report), HasSubstr("quadratic_load_friction"));
}

TEST(Summary, BeginsWithANumberThatActs) {
  ReportRig rig;
  rig.outcome.identification.verdict = Verdict::kNamed;
  rig.outcome.identification.effects = {
      {twin::findEffect("torque_limit"),
       {{"torque_limit.duty", "", 1, 0.996, 1}, {"torque_limit.torque", "N m", 4.86, 4.72, 5}},
       100}};
  rig.make();
  EXPECT_THAT(asText(rig.report), HasSubstr("torque 4.86 N m, with nine chances"));
}

TEST(Summary, GivesNoIntervalForWhatTheDataSayNothingAbout) {
  ReportRig rig;
  rig.outcome.identification.effects.front().estimates.front().seen = false;
  rig.make();
  EXPECT_THAT(asText(rig.report), HasSubstr("(" + std::string{messages::kNotIdentifiable} + ")"));
  EXPECT_THAT(asHtml(rig.report), HasSubstr(messages::kNotIdentifiable));
  EXPECT_THAT(rig.report.model_after, HasSubstr("; friction: " + std::string{messages::kNotIdentifiable}));
  EXPECT_THAT(rig.report.model_after, Not(HasSubstr("90 % interval")));
}

TEST(Summary, WarnsOfAModelThatGotWorseAndOfOneThatIsTooGood) {
  ReportRig rig;
  rig.report.comparison.held_out = gapOfMrad(10, 20, 1);
  EXPECT_THAT(inOneLine(asText(rig.report)), HasSubstr(messages::kWorse));
  EXPECT_THAT(asText(rig.report), Not(HasSubstr(messages::kBelowFloorFlag)));
  rig.report.comparison.held_out = gapOfMrad(10, 10.5, 1);
  EXPECT_THAT(inOneLine(asText(rig.report)), AllOf(HasSubstr(messages::kUnchanged), Not(HasSubstr(messages::kWorse))));
  rig.report.comparison.logs[1].below_floor = true;
  EXPECT_THAT(asText(rig.report), HasSubstr(std::string{messages::kBelowFloorFlag} + "!"));
}

TEST(Summary, SaysThatSomethingIsMissingWhereHeldOutLogsStayAboveTheNoise) {
  ReportRig rig;
  rig.report.comparison.held_out = gapOfMrad(181, 111, 2);
  EXPECT_THAT(helpSentence(rig.report.comparison), EndsWith(messages::kMissingThere));
  rig.report.comparison.held_out = gapOfMrad(181, 3.9, 2);
  EXPECT_THAT(helpSentence(rig.report.comparison), Not(EndsWith(messages::kMissingThere)));
}

TEST(Summary, CallsOnlyGrowthWithinNoiseUnchanged) {
  ReportRig rig;
  rig.report.comparison.held_out = gapOfMrad(100, 104, 1);
  EXPECT_THAT(helpSentence(rig.report.comparison),
              AllOf(HasSubstr(std::string{messages::kGrowsSlightly} + "100 mrad to 104 mrad"),
                    Not(HasSubstr(messages::kUnchanged)), Not(HasSubstr(messages::kWorse))));
  rig.report.comparison.held_out = gapOfMrad(100, 104, 5);
  EXPECT_THAT(helpSentence(rig.report.comparison),
              AllOf(HasSubstr(messages::kUnchanged), Not(HasSubstr(messages::kGrowsSlightly))));
}

TEST(Summary, HasTheShareOfChanceThatIsTrue) {
  ReportRig rig;
  Identification& identification = rig.outcome.identification;
  EXPECT_EQ(chanceShare(identification), "1 %");
  EXPECT_THAT(asText(rig.report), HasSubstr("(1 %)"));
  identification.misfit = 2 * thresholds::kMisfitSigmas;  // the greatest gain of 40 replicas: chance 1 in 41
  const std::string share = chanceShare(identification);
  EXPECT_EQ(share, "at most 2.5 %");
  EXPECT_THAT(asText(rig.report), HasSubstr("(" + share + ")"));
  EXPECT_THAT(asHtml(rig.report), HasSubstr(" " + share + " "));
  EXPECT_THAT(additionsOf(rig.given, rig.outcome, "").effects.front().because.front(), HasSubstr(" " + share + " "));
}

TEST(Summary, NamesFirstWhatIsInEverySet) {
  ReportRig rig;
  Identification& identification = rig.outcome.identification;
  identification.verdict = Verdict::kAmbiguous;
  const auto sentence = [&] { return verdictSentences(rig.outcome, rig.report.comparison).front(); };
  identification.effects.push_back({twin::findEffect("viscous"), {}, 0, false});
  identification.rivals = {{{"coulomb", "torque_limit", "backlash"}, 0}, {{"coulomb", "torque_limit", "backlash"}, 0}};
  EXPECT_THAT(sentence(), HasSubstr("lacks dry friction, and " + std::string{messages::kNotIdentified} +
                                    "viscous friction, or torque limit and gear backlash."));
  identification.rivals.push_back({{"coulomb"}, 0});
  EXPECT_THAT(sentence(), HasSubstr("lacks dry friction" + std::string{messages::kPerhaps} +
                                    "viscous friction or torque limit and gear backlash."));
  identification.rivals.clear();
  for (const char* const id : {"backlash", "deadband", "stribeck", "cogging"})
    identification.rivals.push_back({{id}, 0});
  EXPECT_THAT(sentence(), HasSubstr("lacks " + std::string{messages::kNotIdentified} +
                                    "dry friction and viscous friction, or gear backlash, or "));
  EXPECT_THAT(sentence(), HasSubstr(", or others."));
  identification.effects.clear();
  identification.rivals = {{{"backlash"}, 0}, {{"deadband"}, 0}};
  EXPECT_THAT(sentence(), HasSubstr(std::string{messages::kNotIdentified} + "gear backlash, or dead band."));
}

TEST(Summary, HasASentenceForEachVerdict) {
  ReportRig rig;
  const std::pair<Verdict, std::string> sentences[] = {
      {Verdict::kNone, messages::kOnlyNoise},
      {Verdict::kAmbiguous, messages::kNotIdentified + std::string{"dry friction, or dead band"}},
      {Verdict::kUnknown, messages::kOutsideCatalogue + std::string{"; it shows most between 0.3 and 0.6 s of fit"}},
      {Verdict::kCannotTell, messages::kTooLittle}};
  rig.outcome.identification.rivals.front().behind = 3;
  for (const auto& [verdict, words] : sentences) {
    rig.outcome.identification.verdict = verdict;
    EXPECT_THAT(verdictSentences(rig.outcome, rig.report.comparison).front(), HasSubstr(words));
  }
}

TEST(Compare, ARightModelIsAtTheFloorAndAWrongOneAbove) {
  const Case bench = twoLogs();
  const Hypothesis truth = withEffect(bench, "coulomb", "friction", 0.06);
  const Comparison found = compare(measured(bench, truth, 3), baselineOf(bench), truth);
  EXPECT_EQ(found.held_out_logs, 1U);
  EXPECT_GT(found.held_out.floorsBefore(), 3);
  EXPECT_NEAR(found.held_out.floorsAfter(), 1, 0.5);
  EXPECT_FALSE(found.anyBelowFloor()) << found.logs[1].noise_share;
}

TEST(Compare, LogsOutsideOfTheSearchShowTheErrorToo) {
  const Case bench = twoLogs();
  const Hypothesis truth = withEffect(bench, "coulomb", "friction", 0.06);
  Case given = measured(bench, truth, 3);
  const Comparison all = compare(given, baselineOf(bench), truth);
  given.others.push_back(given.logs.back());
  given.logs.pop_back();
  const Comparison found = compare(given, baselineOf(bench), truth);
  EXPECT_EQ(found.other_logs, 1U);
  EXPECT_EQ(found.held_out_logs, 0U);
  EXPECT_DOUBLE_EQ(found.others.before_rad, all.held_out.before_rad);
  EXPECT_DOUBLE_EQ(found.others.after_rad, all.held_out.after_rad);
  EXPECT_THAT(asText(given, found), AllOf(HasSubstr(messages::kOtherLogs), Not(HasSubstr("nan"))));
  EXPECT_THAT(asText(bench, all), Not(HasSubstr(messages::kOtherLogs)));
}

TEST(Compare, DataWithoutNoiseAreBelowTheFloor) {
  Case bench = twoLogs();
  Trace trace;
  for (std::size_t i = 0; i < bench.logs.size(); ++i) {
    rollOut(bench, i, baselineOf(bench), {}, trace);
    bench.logs[i].position_rad = trace[kPositionSignal];
  }
  const Comparison found = compare(bench, baselineOf(bench), baselineOf(bench));
  EXPECT_TRUE(found.logs[1].below_floor) << "no servo agrees to the last digit with a simulation";
  EXPECT_FALSE(found.logs[0].below_floor) << "a fit comes close to the noise of its logs as well";
  EXPECT_TRUE(found.anyBelowFloor());
}

}  // namespace
}  // namespace darwinop::gap
