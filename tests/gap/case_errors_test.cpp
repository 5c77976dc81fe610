// A case.json with a mistake is refused, and the message names it.
#include <gmock/gmock.h>

#include <ostream>

#include "gap/case/messages.hpp"
#include "gap/case_texts.hpp"

namespace darwinop::gap {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Mistake {
  std::string what, by, says;
  friend std::ostream& operator<<(std::ostream& out, const Mistake& m) { return out << m.by; }
};

class CaseMistake : public testing::TestWithParam<Mistake> {};

TEST_P(CaseMistake, IsNamedWithItsPath) {
  const std::string error = CaseTexts{}.with(GetParam().what, GetParam().by).error();
  EXPECT_THAT(error, AllOf(StartsWith("my/"), HasSubstr(GetParam().says)));
}

INSTANTIATE_TEST_SUITE_P(
    Json, CaseMistake,
    testing::Values(
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": \"1.8\"",
                "my/case.json: `baseline.params.kt_Nm_A` is \"1.8\"; it has to be a number, 0.01 to 10 N m/A"},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": -1.8", "`baseline.params.kt_Nm_A` is -1.8"},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": 10.1", "`baseline.params.kt_Nm_A` is 10.1"},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": null", "`baseline.params.kt_Nm_A` is null"},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": 1e999", messages::kDigitsBeyondDouble},
        Mistake{"\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": NaN", "my/case.json, line 9: this is not JSON"},
        Mistake{"\"kt_Nm_A\": 1.8,", "", "`baseline.params.kt_Nm_A` is missing"},
        Mistake{"\"R_ohm\": 8.5", "\"R_ohm\": 8.5, \"R_ohm\": 9", "\"R_ohm\" is there twice"},
        Mistake{"\"R_ohm\": 8.5", "\"R_ohm\": 8.5, \"kt_NmA\": 9",
                "`baseline.params.kt_NmA` is not known; did you mean kt_Nm_A?"},
        Mistake{"\"duty_max\": 1.0", "\"duty_max\": 1.01", "`baseline.params.duty_max` is 1.01"},
        Mistake{"\"length_m\": 0.17", "\"length_m\": 0", "`baseline.params.length_m` is 0"},
        Mistake{"\"coulomb_Nm\": 0.08", "\"coulomb_Nm\": 0.4", "`baseline.params.coulomb_Nm` is 0.4"},
        Mistake{"\"voltage_p\"", "\"voltage\"", "`baseline.model` is \"voltage\"; it has to be voltage_p or speed_p"},
        Mistake{"\"family\"", "\"goal_order\": \"later\", \"family\"", "`goal_order` is \"later\""},
        Mistake{"\"family\"", "\"famly\": 1, \"family\"", "`famly` is not known"},
        Mistake{"\"kp\": 32", "\"from\": 1, \"kp\": 32", "`logs[0].from` is not known; did you mean from_s?"},
        Mistake{"\"kp\": 32", "\"hangs_at\": 1, \"kp\": 32",
                "`logs[0].hangs_at` is not known; did you mean hangs_at_rad?"},
        Mistake{"\"R_ohm\": 8.5", "\"R_ohm\": 8.5, \"spin_Nm\": 1", "`baseline.params.spin_Nm` is not known"},
        Mistake{"\"kt_Nm_A\": 0.02", "\"kt_Nm_A\": 0", "`prior_rel_sigma.kt_Nm_A` is 0"},
        Mistake{"\"kt_Nm_A\": 0.02", "\"kt_Nm_A\": 0.02, \"kt\": 0.03", messages::kSecondSigma},
        Mistake{"\"kt_Nm_A\": 0.02", "\"kt_Nm_A\": 0.02, \"coulomb.fricton\": 0.1", messages::kUnknownParameter},
        Mistake{"\"tiny\"", "\"a;b\"", "`case` is not a valid name"},
        Mistake{"\"tiny\"", "7", "`case` is 7; it has to be a text"},
        Mistake{"\"kp\": 32", "\"kp\": -1", "`logs[0].kp` is -1"},
        Mistake{"\"payload_kg\": 0.3", "\"payload_kg\": true", "`logs[0].payload_kg` is true"},
        Mistake{"\"role\": \"score\"", "\"role\": \"test\"",
                "`logs[1].role` is \"test\"; it has to be fit, held_out or score"},
        Mistake{"\"role\": \"fit\"", "\"role\": \"score\"", "`logs` has no log with \"role\": \"fit\""},
        Mistake{"\"file\": \"fit_1.csv\"", "\"file\": \"fit_2.csv\"", "my/fit_2.csv: there is no such file"},
        Mistake{"\"file\": \"fit_1.csv\"", "\"file\": \"../fit_1.csv\"", "`logs[0].file` is outside"},
        Mistake{"\"file\": \"fit_1.csv\"", "\"file\": \"score_1.csv\"", "`logs[1].file` is there twice"},
        Mistake{"\"repeat_of\": null", "\"repeat_of\": \"fit_9.csv\"", "`logs[0].repeat_of` names no log"},
        Mistake{"\"repeat_of\": null", "\"repeat_of\": \"fit_1.csv\"", "`logs[0].repeat_of` names the log itself"},
        Mistake{"\"kp\": 32, ", "", "my/fit_1.csv: the case does not have its P register"},
        Mistake{"\"kp\": 32", "\"joint\": \"Nek\", \"kp\": 32", "`logs[0].joint` is not a joint; did you mean Neck?"},
        Mistake{"\"kp\": 32", "\"joint\": \"Neck\", \"kp\": 32", messages::kOtherJoint},
        Mistake{"\"kp\": 32", "\"from_s\": 2, \"to_s\": 1, \"kp\": 32", "`logs[0].to_s` is not after"},
        Mistake{"\"logs\"", "\"model\": \"a.ini\", \"logs\"", "`model` and `baseline` are two models"},
        Mistake{"\"logs\"", "\"servo_datasheet\": {\"stall_Nm\": 2.5, \"stall_A_at_5V\": 1.4}, \"logs\"",
                messages::kOtherDatasheetVoltage},
        Mistake{"\"logs\": [", "\"logs\": [3,", "`logs[0]` is 3; it has to be an object"}));

TEST(CaseMistakes, RangesIncludeTheirEnds) {
  EXPECT_EQ(CaseTexts{}.with("\"kt_Nm_A\": 1.8", "\"kt_Nm_A\": 10").error(), "");
  EXPECT_EQ(CaseTexts{}.with("\"coulomb_Nm\": 0.08", "\"coulomb_Nm\": 0.3").error(), "");
  EXPECT_EQ(CaseTexts{}.with("\"duty_max\": 1.0", "\"duty_max\": 1").error(), "");
}

TEST(CaseMistakes, NotesMayStandAnywhere) {
  EXPECT_EQ(CaseTexts{}.with("\"kt_Nm_A\": 1.8", "\"note\": \"measured\", \"kt_Nm_A\": 1.8").error(), "");
  EXPECT_EQ(CaseTexts{}.with("\"kp\": 32", "\"comment\": \"after lunch\", \"kp\": 32").error(), "");
}

TEST(CaseMistakes, SomethingElseThanAnObject) {
  CaseTexts texts;
  texts.json = "[1, 2]";
  EXPECT_EQ(texts.error(), "my/case.json: not a JSON object; a case begins with { and ends with }");
  texts.json = "";
  EXPECT_THAT(texts.error(), StartsWith("my/case.json, line 1: this is not JSON"));
}

}  // namespace
}  // namespace darwinop::gap
