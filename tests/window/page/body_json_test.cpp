// The page's geometry is the twin's body, complete and in order.
#include "window/page/body_json.hpp"

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/joints.hpp"

namespace darwinop {
namespace {

const nlohmann::json& shownBody() {
  static const nlohmann::json body = nlohmann::json::parse(window::bodyJson("darwin-op"));
  return body;
}

TEST(BodyJson, EveryServoMovesOneLink) {
  std::map<std::string, int> links;
  for (const auto& link : shownBody()["links"])
    if (!link["joint"].is_null()) ++links[link["joint"]["name"].get<std::string>()];
  EXPECT_EQ(links.size(), kJoints);
  for (const JointRow& joint : kJointTable) EXPECT_EQ(links[std::string{joint.name}], 1) << joint.name;
}

TEST(BodyJson, ParentsPrecedeTheirChildren) {
  const auto& links = shownBody()["links"];
  EXPECT_EQ(links[0]["parent"], -1);
  for (std::size_t i = 1; i < links.size(); ++i) {
    EXPECT_GE(links[i]["parent"].get<int>(), 0);
    EXPECT_LT(links[i]["parent"].get<std::size_t>(), i) << links[i]["name"];
  }
}

TEST(BodyJson, TheTrunkHasShapesToDrawAndNoFloorOrBall) {
  EXPECT_GT(shownBody()["links"][0]["shapes"].size(), 3U);
  for (const auto& link : shownBody()["links"]) EXPECT_NE(link["name"], "ball");
}

TEST(BodyJson, TheAccelerometersUpAxisIsTheTrunks) {
  // In the trunk y is up; the sensor's z axis is its quaternion's third column.
  const auto q = shownBody()["sensors"]["accelerometer"]["quat"].get<std::vector<double>>();
  EXPECT_NEAR(2 * (q[2] * q[3] - q[0] * q[1]), 1, 1e-6);
}

TEST(BodyJson, AMissingModelIsReportedByName) {
  EXPECT_THAT([] { window::bodyJson("nobody"); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("nobody")));
}

}  // namespace
}  // namespace darwinop
