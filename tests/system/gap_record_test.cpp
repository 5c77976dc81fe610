// A whole robot from its recordings to its corrected model, each step by its command: the robot is a twin in which
// something is hidden.
#include "system/gap_rig.hpp"

namespace darwinop {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kNamed = 10;  // exit code of darwinop gap run

class GapRecord : public GapRig {
 protected:
  /// Names with their places, after `run`.
  std::vector<std::string> names() {
    EXPECT_EQ(gap({"run", file("case"), "--report", file("report"), "--no-open"}, seconds{500}), kNamed) << said_;
    answer_ = json::parse(textOf(file("report/report.json")));
    std::vector<std::string> names;
    for (const json& effect : answer_["effects"])
      names.push_back(effect["id"].get<std::string>() + " at " + effect["at"].get<std::string>());
    return names;
  }
  [[nodiscard]] json params(const std::string& id) const {
    for (const json& effect : answer_["effects"])
      if (effect["id"] == id) return effect["params"];
    return {};
  }
  void expectTheModelClosesWhatIsOpen() {
    ASSERT_EQ(gap({"add", file("case"), file("report/report.json"), "--out", file("repaired.ini")}, seconds{20}), 0)
        << said_;
    EXPECT_THAT(openSignals(file("repaired.ini")), IsEmpty());
  }

  json answer_;
};

TEST_F(GapRecord, FrictionOfAnElbowAndABiasOfTheGyroscopeAreNamedAndTheModelWithThemHasNothingOpen) {
  record(robotWith("gyro_bias = 0.2, 0, 0 rad/s\ngyro_noise = 0.05 rad/s\n",
                   "[effect coulomb ArmLowerR]\nfriction = 0.12 N m\n"));
  EXPECT_THAT(openSignals("darwin-op"), Contains("gyro.x"));
  ASSERT_THAT(names(), testing::UnorderedElementsAre("coulomb at ArmLowerR", "gyro_bias at gyro"));
  EXPECT_NEAR(params("coulomb")["friction"].get<double>(), 0.12, 0.006);
  EXPECT_NEAR(params("gyro_bias")["bias"][0].get<double>(), 0.2, 0.01);
  EXPECT_LT(answer_["gap_score_after"]["joints_mrad"], 0.5 * answer_["gap_score_before"]["joints_mrad"].get<double>());
  EXPECT_THAT(textOf(file("report/report.html")), HasSubstr("ArmLowerR"));
  expectTheModelClosesWhatIsOpen();
  EXPECT_THAT(textOf(file("repaired.ini")), HasSubstr("[effect coulomb ArmLowerR]"));
}

}  // namespace
}  // namespace darwinop
