// Example cases of another simulator, where they are there: effects of joints and links, against the answer key. The
// key is read by this test alone.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "gap/identify/body/body_identification.hpp"
#include "support/shared_data.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

fs::path mechanicsExamples() {
  return sharedData("body-gap-cases");
}

nlohmann::ordered_json answerTo(const std::string& name) {
  const BodyCase c = readBodyCase((mechanicsExamples() / "cases" / name).string());
  return asJson(c, identify(c));
}

struct Expected {
  const char *name, *id;
  nlohmann::json at;
  const char* parameter;
  double value;
  double left_floors = 1.15;  // of the held-out joints
};

TEST(BodyMechanicsExamples, EffectsOfJointsAndLinksAreNamedWithTheirNumbers) {
  if (!fs::exists(mechanicsExamples())) GTEST_SKIP() << "no example cases in " << mechanicsExamples();
  for (const Expected& one :
       {Expected{"x04", "link_mass", "ArmLowerL", "mass", 0.055},
        Expected{"x08", "coulomb", "ArmUpperR", "friction", 0.125}, Expected{"x09", "backlash", "PelvR", "play", 0.02},
        Expected{"x11", "transport_delay", "all", "delay", 0.014}, Expected{"x12", "viscous", "Neck", "damping", 0.052},
        Expected{"x10", "torque_limit", {"LegUpperR", "LegUpperL"}, "duty", 0.35, 2.7}}) {
    const nlohmann::ordered_json answer = answerTo(one.name);
    std::vector<std::string> found;
    for (const auto& effect : answer["effects"]) {
      found.push_back(effect["id"]);
      if (effect["id"] != one.id) continue;
      EXPECT_EQ(effect["at"], one.at) << one.name;
      EXPECT_NEAR(effect["params"][one.parameter].get<double>(), one.value, 0.1 * one.value) << one.name;
    }
    EXPECT_THAT(found, testing::Contains(std::string{one.id})) << one.name;
    EXPECT_LT(answer["gap_score_after"]["joints_mrad"].get<double>(),
              one.left_floors * answer["floor"]["joints_mrad"].get<double>())
        << one.name;
  }
}

TEST(BodyMechanicsExamples, ARobotLikeItsModelAndACableHaveNoName) {
  if (!fs::exists(mechanicsExamples())) GTEST_SKIP() << "no example cases in " << mechanicsExamples();
  EXPECT_TRUE(answerTo("x13")["effects"].empty());
  const nlohmann::ordered_json cable = answerTo("x14");
  EXPECT_EQ(cable["verdict"], "unknown");
  EXPECT_EQ(cable["where"][0]["signal"], "Neck.position");
}

}  // namespace
}  // namespace darwinop::gap
