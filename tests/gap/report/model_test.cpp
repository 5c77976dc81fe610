// Findings written to model files: reading them back gives the same model; nonsense is refused.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/text/nearest.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/line_diff.hpp"
#include "gap/report/model_text.hpp"
#include "gap/report/read_results.hpp"
#include "gap/report/report_rig.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/sections.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kModel =
    "; my servo\n[model]\nname = mine\n\n[servo]\nkt = 1.8 N m/A  ; measured on Monday\nresistance = 8 ohm\n\n"
    "; as new\n[effect viscous]\ndamping = 0.01 N m s/rad\n";

std::string repairedModel(const ReportRig& rig) {
  return withAdditions(caseModel(rig.given), additionsOf(rig.given, rig.outcome, dataHash(rig.given)));
}

std::string sentenceOf(const std::function<void()>& wrong) {
  try {
    wrong();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(RepairedModel, ReadBackIsTheHypothesisThatWasFound) {
  const ReportRig rig;
  const Case again = withModel(rig.given, twin::parseModel(repairedModel(rig), "repaired.ini"));
  const Hypothesis read = baselineOf(again), found = rig.outcome.identification.model;
  EXPECT_EQ(movedNumbers(read.servo, rig.given.model.servo).size(), 1U) << "kt, nothing else";
  EXPECT_NEAR(read.servo.kt_nm_a, found.servo.kt_nm_a, 1e-5);
  ASSERT_EQ(read.effects.size(), found.effects.size());
  for (std::size_t i = 0; i < read.effects.size(); ++i) {
    EXPECT_EQ(read.effects[i].info, found.effects[i].info);
    ASSERT_EQ(read.effects[i].values.size(), found.effects[i].values.size());
    for (std::size_t j = 0; j < read.effects[i].values.size(); ++j)
      EXPECT_NEAR(read.effects[i].values[j], found.effects[i].values[j], 1e-6);
  }
}

TEST(RepairedModel, HasIntervalsAndSourceInComments) {
  const ReportRig rig;
  for (const char* comment :
       {"; Found by darwinop gap in the logs of case e<1>", "; friction: 90 % interval 0.0401 to 0.0447 N m",
        "; sha256 of the data: aaaa", "; was 1.786 N m/A", "; Moved by the fit"})
    EXPECT_THAT(rig.report.model_after, HasSubstr(comment));
}

// The delay of the answer begins when a goal arrives, that of the model with the firmware's next period.
TEST(RepairedModel, HasIntervalsOfItsOwnNumbers) {
  ReportRig rig;
  const twin::EffectInfo& delay = *twin::findEffect("transport_delay");
  rig.outcome.identification.model.with(delay).values[0] = 0.0215;
  rig.outcome.identification.effects = {{&delay, {{"transport_delay.delay", "s", 0.021, 0.019, 0.023}}, 99}};
  rig.make();
  const auto has = AllOf(HasSubstr("delay = 0.0215 s"), HasSubstr("; delay: 90 % interval 0.0195 to 0.0235 s"));
  EXPECT_THAT(rig.report.model_after, has);
  const Additions again = additionsIn(asJson(rig.report).dump(), "report.json", rig.given);
  EXPECT_THAT(withAdditions(caseModel(rig.given), again), has);
}

TEST(RepairedModel, IsMadeAgainFromTheReport) {
  const ReportRig rig;
  const Additions additions = additionsIn(asJson(rig.report).dump(), "report.json", rig.given);
  EXPECT_EQ(withAdditions(caseModel(rig.given), additions), rig.report.model_after);
  nlohmann::json shortened = asJson(rig.report);
  shortened["effects"][0].erase("params");  // the model's values are enough
  EXPECT_EQ(withAdditions(caseModel(rig.given), additionsIn(shortened.dump(), "report.json", rig.given)),
            rig.report.model_after);
}

TEST(RepairedModel, IsMadeFromTheResultsOfASuite) {
  const ReportRig rig;
  const nlohmann::json results{badInput("other", "no logs"), asJson(rig.given, rig.outcome)};
  const std::string text = withAdditions(caseModel(rig.given), additionsIn(results.dump(), "results.json", rig.given));
  EXPECT_THAT(text, HasSubstr("friction = 0.0423 N m"));
}

TEST(RepairedModel, NamesRivalsThatTheDataDoNotExclude) {
  ReportRig rig;
  rig.outcome.identification.verdict = Verdict::kAmbiguous;
  rig.outcome.identification.rivals.front().behind = 3;
  EXPECT_THAT(repairedModel(rig), HasSubstr("; Not certain: deadband explains the logs"));
}

TEST(ServoNumber, ChangesItsLineAndNoOther) {
  const std::string text = withNumber(kModel, "servo", "kt", 1.75);
  EXPECT_THAT(text, HasSubstr("\nkt = 1.75 N m/A  ; was 1.8 N m/A; measured on Monday\nresistance = 8 ohm\n"));
  EXPECT_THAT(text, HasSubstr("; my servo\n"));
  EXPECT_THAT(withNumber(kModel, "servo", "armature", 0.004), HasSubstr("resistance = 8 ohm\narmature = 0.004 kg m2"));
  EXPECT_THAT(withNumber("[model]\nname = mine", "servo", "kt", 1.75), HasSubstr("\n[servo]\nkt = 1.75 N m/A"));
}

TEST(ServoNumber, KeepsTheNoteOfItsSource) {
  const std::string twice = withNumber(withNumber(kModel, "servo", "kt", 1.75), "servo", "kt", 1.7);
  EXPECT_THAT(twice, HasSubstr("kt = 1.7 N m/A  ; was 1.75 N m/A; was 1.8 N m/A; measured on Monday\n"));
  const std::string note(150, 'x'), longer = "[model]\nname = a\n[servo]\nkt = 1.5 N m/A  # " + note + "\n";
  EXPECT_THAT(withNumber(withNumber(longer, "servo", "kt", 1.75), "servo", "kt", 1.7),
              HasSubstr("; was 1.5 N m/A; " + note + "\nkt = 1.7 N m/A  ; was 1.75 N m/A\n"));
}

TEST(ServoNumber, HasTheLineEndsOfItsFile) {
  const std::string text = "[model]\r\nname = a\r\n[servo]\r\nkt = 1.5 N m/A  ; mine\r\n";
  const std::string both = withNumber(withNumber(text, "servo", "kt", 1.75), "servo", "armature", 0.004);
  EXPECT_EQ(std::ranges::count(both, '\n'), std::ranges::count(both, '\r'));
  EXPECT_THAT(both, HasSubstr("; was 1.5 N m/A; mine\r\narmature = 0.004 kg m2"));
}

TEST(ServoNumber, OfAnUnknownNameIsRefused) {
  // As models.md allows: any case, and a colon.
  EXPECT_EQ(
      twin::parseModel(withNumber("[model]\nname = a\n[servo]\nKT: 1.5 N m/A\n# kt = 2\n", "servo", "kt", 1.75), "a")
          .servo.kt_nm_a,
      1.75);
  EXPECT_THAT(sentenceOf([] { withNumber(kModel, "servo", "ktt", 1.75); }), HasSubstr("did you mean kt?"));
  EXPECT_THAT(sentenceOf([] { withNumber(kModel, "servo", "kt", -1); }), HasSubstr("kt"));
}

TEST(AddByHand, PutsEffectsIntoTheFileAndLeavesItsComments) {
  const std::string text =
      withAdditions(kModel, additionsFrom({"stribeck.friction=0.06", "stribeck.speed=0.2", "coulomb.friction=0.05"}));
  EXPECT_THAT(text, HasSubstr("; as new\n[effect viscous]"));
  EXPECT_THAT(text, HasSubstr("[effect coulomb]\nfriction = 0.05 N m"));
  EXPECT_THAT(text, HasSubstr("[effect stribeck]\nfriction = 0.06 N m\nspeed = 0.2 rad/s"));
  EXPECT_THAT(text, HasSubstr("exponent: " + std::string{messages::kTypicalValue}));
}

TEST(AddByHand, SaysWhichNumbersWereNotGiven) {
  EXPECT_THAT(
      changesBy(additionsFrom({"torque_limit.torque=2"}), twin::parseModel(kModel, "m")),
      ElementsAre("torque_limit added", HasSubstr("torque_limit.duty = 0.6: " + std::string{messages::kTypicalValue})));
}

TEST(AddByHand, LeavesTheOtherParametersOfAnEffectThatIsThere) {
  const std::string there = std::string{kModel} +
                            "[effect stribeck]\nfriction = 0.01 N m\nspeed = 0.33 rad/s\nexponent = 1.5\n" +
                            "[effect stribeck Neck]\nfriction = 0.01 N m\nspeed = 0.5 rad/s\nexponent = 1.5\n";
  const std::string text = withAdditions(there, additionsFrom({"stribeck.friction=0.02"}));
  EXPECT_THAT(text, HasSubstr("[effect stribeck]\nfriction = 0.02 N m\nspeed = 0.33 rad/s"));
  EXPECT_THAT(text, HasSubstr("[effect stribeck Neck]\nfriction = 0.02 N m\nspeed = 0.5 rad/s"));
  EXPECT_THAT(text, Not(HasSubstr(messages::kTypicalValue)));
}

struct Refused {
  const char* effect;
  std::string says;
};
class AddNonsense : public testing::TestWithParam<Refused> {};

TEST_P(AddNonsense, IsRefusedWithASentence) {
  EXPECT_THAT(sentenceOf([] { withAdditions(kModel, additionsFrom({GetParam().effect})); }),
              HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(All, AddNonsense,
                         testing::Values(Refused{"coulomb", "write ID.PARAMETER=VALUE"},
                                         Refused{"coulmb.friction=0.05", text::suggestion("coulmb", twin::effectIds())},
                                         Refused{"coulomb.fricton=0.05", "did you mean friction?"},
                                         Refused{"coulomb.friction=5", "give 0 to 4 N m"},
                                         Refused{"coulomb.friction=nan", "give 0 to 4 N m"},
                                         Refused{"coulomb.friction=0.05 N m", messages::kUnitNotAllowed},
                                         Refused{"coulomb.friction=", messages::kUnitNotAllowed}));

TEST(AddByHand, TheSameParameterTwiceIsRefused) {
  EXPECT_THAT(sentenceOf([] {
                additionsFrom({"coulomb.friction=0.05", "coulomb.friction=0.06"});
              }),
              HasSubstr(messages::kNumberGivenTwice));
}

TEST(AddByHand, AnEffectWithoutEquationNeedsTheLawThatHasOne) {
  const std::string speed = "[model]\nname = a\n[servo]\nlaw = speed_p\n";
  EXPECT_THAT(sentenceOf([&] { withAdditions(speed, additionsFrom({"integral.gain=20"})); }),
              HasSubstr("integral.gain" + std::string{twin::messages::kNoEquation}));
  EXPECT_THAT(withAdditions(speed, additionsFrom({"integral.gain=20", "p_on_torque.on=1"})),
              HasSubstr("[effect integral]\ngain = 20 1/s"));
}

constexpr const char* kRobot =
    "[model]\nname = robot\n[servo]\nkt = 1.786 N m/A\n[effect coulomb]\nfriction = 0.02 N m\n"
    "[effect coulomb AnkleR]\nfriction = 0.2 N m\n[effect viscous]\ndamping = 0.012 N m s/rad\n";

TEST(AddResults, OfOneJointChangeNoOtherOfTheRobot) {
  ReportRig rig;
  rig.given.joint = Joint::kShoulderR;
  const Additions additions = additionsIn(asJson(rig.report).dump(), "report.json", rig.given);
  const std::string text = withAdditions(kRobot, additions);
  const twin::Model was = twin::parseModel(kRobot, "m"), now = twin::parseModel(text, "m");
  EXPECT_EQ(servoEffects(now, Joint::kNeck).front().values, servoEffects(was, Joint::kNeck).front().values);
  EXPECT_EQ(servoEffects(now, Joint::kAnkleR).front().values, servoEffects(was, Joint::kAnkleR).front().values);
  EXPECT_THAT(text, HasSubstr("[effect coulomb ShoulderR]\nfriction = 0.0423 N m"));
  EXPECT_THAT(text, HasSubstr("[effect viscous ShoulderR]\ndamping = 0.0161 N m s/rad")) << "a number of the fit";
  EXPECT_THAT(changesBy(additions, was),
              testing::ElementsAre("coulomb at ShoulderR added", "[servo] kt changed, for all joints"));
  // Compared on the logs of that joint, the model is the one that was found.
  const Hypothesis read = baselineOf(withModel(rig.given, now));
  EXPECT_EQ(read.find("coulomb")->values.front(), 0.0423);
  EXPECT_EQ(read.find("viscous")->values.front(), 0.0161);
}

TEST(AddByHand, ToAllJointsListsTheirSections) {
  EXPECT_THAT(changesBy(additionsFrom({"coulomb.friction=0.05"}), twin::parseModel(kRobot, "m")),
              testing::ElementsAre("coulomb replaced", "coulomb at AnkleR replaced"));
}

TEST(AddResults, ThatNameNothingAreRefused) {
  ReportRig rig;
  const auto sentence = [&](const std::string& text) {
    return sentenceOf([&] { additionsIn(text, "report.json", rig.given); });
  };
  rig.outcome.identification.verdict = Verdict::kNone;
  EXPECT_THAT(sentence(asJson(rig.report).dump()), HasSubstr("report.json: nothing is missing by this result"));
  rig.outcome.identification.verdict = Verdict::kUnknown;
  EXPECT_THAT(sentence(asJson(rig.report).dump()), AllOf(HasSubstr("unknown"), HasSubstr(messages::kNamesNoEffect)));
  rig.outcome.identification.verdict = Verdict::kNamed;
  rig.given.name = "other";
  nlohmann::json of_e1 = asJson(rig.report);
  of_e1["case"] = "e1";
  EXPECT_THAT(sentence(of_e1.dump()), HasSubstr("is of case e1, not of other"));
  EXPECT_THAT(sentence("[]"), HasSubstr("has no result of case other"));
  EXPECT_THAT(sentence("{\"case\": 3"), HasSubstr(std::string{"report.json: "} + messages::kNotAResult));
}

TEST(PlanFromResults, BeginsWithTheNamesAndRivalsOfARun) {
  ReportRig rig;
  rig.outcome.identification.verdict = Verdict::kAmbiguous;
  rig.outcome.identification.rivals = {{{"coulomb", "backlash"}, 3}, {{"deadband"}, 45}};
  nlohmann::json report = asJson(rig.report);
  const auto read = [&] { return identifiedIn(report.dump(), "report.json", rig.given); };
  const Identification found = read();
  EXPECT_EQ(found.verdict, Verdict::kAmbiguous);
  ASSERT_EQ(found.effects.size(), 1U);
  EXPECT_EQ(found.effects.front().effect->id, "coulomb");
  ASSERT_EQ(found.rivals.size(), 2U);
  EXPECT_EQ(found.rivals[0].effects, (std::vector<std::string>{"coulomb", "backlash"}));
  EXPECT_EQ(found.rivals[1].behind, 45);
  report["verdict"] = "bad_input";
  EXPECT_THAT(sentenceOf(read), HasSubstr("report.json: has the verdict bad_input"));
  report["verdict"] = "named";
  report["effects"][0]["id"] = "gremlins";
  EXPECT_THAT(sentenceOf(read), HasSubstr("gremlins"));
  report.erase("rivals");
  report["effects"] = nlohmann::json::array();
  EXPECT_THAT(sentenceOf(read), HasSubstr(messages::kNoRivals)) << "results.json has no rivals";
  report["rivals"] = 3;
  EXPECT_THAT(sentenceOf(read), HasSubstr(messages::kNotAResult));
  report["case"] = "other";
  EXPECT_THAT(sentenceOf(read), HasSubstr("is of case other"));
}

TEST(LineDiff, ShowsWhatChangedWithALittleAround) {
  const auto kinds = [](const std::vector<DiffLine>& lines) {
    std::string text;
    for (const DiffLine& line : lines) text += line.kind;
    return text;
  };
  EXPECT_EQ(kinds(lineDiff("a\nb\nc\n", "a\nb\nc\n")), "");
  EXPECT_EQ(kinds(lineDiff("a\nb\nc\nd\ne\nf\ng\nh\n", "a\nB\nc\nd\ne\nf\ng\nh\ni\n", 1)), " -+ @ +");
  EXPECT_EQ(kinds(lineDiff("", "a\n")), "+");
}

}  // namespace
}  // namespace darwinop::gap
