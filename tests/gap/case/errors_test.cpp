// A case.json with a mistake is refused, and the message names it.
#include <gmock/gmock.h>

#include <ostream>

#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Mistake {
  std::string what, by;
  std::vector<std::string> says;
  friend std::ostream& operator<<(std::ostream& out, const Mistake& m) { return out << m.by; }
};

class CaseMistake : public testing::TestWithParam<Mistake> {};

TEST_P(CaseMistake, IsNamedWithItsPath) {
  const std::string error = CaseTexts{}.with(GetParam().what, GetParam().by).error();
  EXPECT_THAT(error, StartsWith("my/"));
  for (const std::string& part : GetParam().says) EXPECT_THAT(error, HasSubstr(part));
}

INSTANTIATE_TEST_SUITE_P(
    Json, CaseMistake,
    testing::Values(
        Mistake{"\"kt_Nm_A\": 1.8",
                "\"kt_Nm_A\": \"1.8\"",
                {"my/case.json", "`baseline.params.kt_Nm_A`", "\"1.8\"", "0.01 to 10 N m/A"}},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": -1.8", {"`baseline.params.kt_Nm_A`", "-1.8"}},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": 10.1", {"`baseline.params.kt_Nm_A`", "10.1"}},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": null", {"`baseline.params.kt_Nm_A`", "null"}},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": 1e999", {messages::kDigitsBeyondDouble}},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": NaN", {std::string{"my/case.json, line 9: "} + messages::kNotJson}},
        Mistake{"\"kt_Nm_A\": 1.8,", "", {"`baseline.params.kt_Nm_A`", messages::kMissing}},
        Mistake{"\"R_ohm\": 8.5", "\"R_ohm\": 8.5, \"R_ohm\": 9", {"\"R_ohm\"", messages::kGivenTwice}},
        Mistake{"\"R_ohm\": 8.5",
                "\"R_ohm\": 8.5, \"kt_NmA\": 9",
                {"`baseline.params.kt_NmA`", messages::kUnknownKey, "kt_Nm_A?"}},
        Mistake{"\"duty_max\": 1.0", "\"duty_max\": 1.01", {"`baseline.params.duty_max`", "1.01"}},
        Mistake{"\"length_m\": 0.17", "\"length_m\": 0", {"`baseline.params.length_m`", " 0;"}},
        Mistake{"\"coulomb_Nm\": 0.08", "\"coulomb_Nm\": 5", {"`baseline.params.coulomb_Nm`", " 5;"}},
        Mistake{"\"voltage_p\"", "\"voltage\"", {"`baseline.model`", "\"voltage\"", "voltage_p", "speed_p"}},
        Mistake{"\"family\"", "\"goal_order\": \"later\", \"family\"", {"`goal_order`", "\"later\""}},
        Mistake{"\"family\"", "\"famly\": 1, \"family\"", {"`famly`", messages::kUnknownKey}},
        Mistake{"\"kp\": 32", "\"from\": 1, \"kp\": 32", {"`logs[0].from`", messages::kUnknownKey, "from_s?"}},
        Mistake{"\"kp\": 32",
                "\"hangs_at\": 1, \"kp\": 32",
                {"`logs[0].hangs_at`", messages::kUnknownKey, "hangs_at_rad?"}},
        Mistake{
            "\"R_ohm\": 8.5", "\"R_ohm\": 8.5, \"spin_Nm\": 1", {"`baseline.params.spin_Nm`", messages::kUnknownKey}},
        Mistake{"\"kt_Nm_A\": 0.02", "\"kt_Nm_A\": 0", {"`prior_rel_sigma.kt_Nm_A`", " 0;"}},
        Mistake{"\"kt_Nm_A\": 0.02", "\"kt_Nm_A\": 0.02, \"kt\": 0.03", {messages::kSecondSigma}},
        Mistake{"\"kt_Nm_A\": 0.02", "\"kt_Nm_A\": 0.02, \"coulomb.fricton\": 0.1", {messages::kUnknownParameter}},
        Mistake{"\"tiny\"", "\"a;b\"", {"`case`", messages::kInvalidName}}, Mistake{"\"tiny\"", "7", {"`case`", " 7;"}},
        Mistake{"\"kp\": 32", "\"kp\": -1", {"`logs[0].kp`", " -1;"}},
        Mistake{"\"payload_kg\": 0.3", "\"payload_kg\": true", {"`logs[0].payload_kg`", "true"}},
        Mistake{
            "\"role\": \"score\"", "\"role\": \"test\"", {"`logs[1].role`", "\"test\"", "fit", "held_out", "score"}},
        Mistake{"\"role\": \"fit\"", "\"role\": \"score\"", {"`logs`", messages::kNoFitLog}},
        Mistake{"\"role\": \"fit\"", "\"role\": \"other\"", {"`logs`", messages::kNoFitLog}},
        Mistake{"\"role\": \"fit\"", "\"role\": \"validation\"", {"`logs`", messages::kNoFitLog}},
        Mistake{"\"file\": \"fit_1.csv\"", "\"file\": \"fit_2.csv\"", {"my/fit_2.csv: there is no such file"}},
        Mistake{"\"file\": \"fit_1.csv\"", "\"file\": \"../fit_1.csv\"", {"`logs[0].file`", messages::kBeyondFolder}},
        Mistake{"\"file\": \"fit_1.csv\"", "\"file\": \"score_1.csv\"", {"`logs[1].file`", messages::kGivenTwice}},
        Mistake{
            "\"repeat_of\": null", "\"repeat_of\": \"fit_9.csv\"", {"`logs[0].repeat_of`", messages::kRepeatOfNothing}},
        Mistake{
            "\"repeat_of\": null", "\"repeat_of\": \"fit_1.csv\"", {"`logs[0].repeat_of`", messages::kRepeatOfItself}},
        Mistake{"\"kp\": 32, ", "", {"my/fit_1.csv: ", messages::kNoPRegister}},
        Mistake{"\"kp\": 32", "\"joint\": \"Nek\", \"kp\": 32", {"`logs[0].joint`", "Neck?"}},
        Mistake{"\"kp\": 32", "\"joint\": \"Neck\", \"kp\": 32", {messages::kOtherJoint}},
        Mistake{"\"kp\": 32", "\"from_s\": 2, \"to_s\": 1, \"kp\": 32", {"`logs[0].to_s`", messages::kEndBeforeStart}},
        Mistake{"\"logs\"", "\"model\": \"a.ini\", \"logs\"", {"`model`", messages::kTwoModels}},
        Mistake{"\"logs\"",
                "\"servo_datasheet\": {\"stall_Nm\": 2.5, \"stall_A_at_5V\": 1.4}, \"logs\"",
                {messages::kOtherDatasheetVoltage}},
        Mistake{"\"logs\": [", "\"logs\": [3,", {"`logs[0]`", " 3;", "{ }"}}));

TEST(CaseMistakes, AnOtherLogHasNoRepeats) {
  for (const char* const role : {"other", "validation"}) {
    const CaseTexts other = CaseTexts{}.with("\"role\": \"score\"", "\"role\": \"" + std::string{role} + "\"");
    EXPECT_EQ(other.error(), "");
    EXPECT_THAT(other.with("\"repeat_of\": null", "\"repeat_of\": \"score_1.csv\"").error(),
                HasSubstr(messages::kRepeatOfAnother));
  }
}

TEST(CaseMistakes, RangesIncludeTheirEnds) {
  EXPECT_EQ(CaseTexts{}.with("\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": 10").error(), "");
  EXPECT_EQ(CaseTexts{}.with("\"coulomb_Nm\": 0.08", "\"coulomb_Nm\": 3").error(), "");
  EXPECT_EQ(CaseTexts{}.with("\"duty_max\": 1.0", "\"duty_max\": 1").error(), "");
}

TEST(CaseMistakes, NotesMayStandAnywhere) {
  EXPECT_EQ(CaseTexts{}.with("\"kt_Nm_A\": 1.8", "\"note\": \"measured\", \"kt_Nm_A\": 1.8").error(), "");
  EXPECT_EQ(CaseTexts{}.with("\"kp\": 32", "\"comment\": \"after lunch\", \"kp\": 32").error(), "");
}

TEST(CaseMistakes, SomethingElseThanAnObject) {
  CaseTexts texts;
  texts.json = "[1, 2]";
  EXPECT_THAT(texts.error(), StartsWith(std::string{"my/case.json: "} + messages::kNotJsonObject));
  texts.json = "";
  EXPECT_THAT(texts.error(), StartsWith(std::string{"my/case.json, line 1: "} + messages::kNotJson));
}

}  // namespace
}  // namespace darwinop::gap
