// Getting up: from either side, on slippery and rough floors, with arms where a fall has left them, on a weak battery.
#include <gmock/gmock.h>

#include "motions/stage.hpp"

namespace darwinop::motion {
namespace {

struct Fall {
  const char* what;
  StageOptions stage;
  Pose goals;  // where the joints were sent, lying
};

// Left and right differ: falls are not symmetrical.
Pose armsAt(int shoulder_r, int shoulder_l, int elbow_r, int elbow_l) {
  Pose pose = stance();
  pose[index(Joint::kShoulderR)] += shoulder_r;
  pose[index(Joint::kShoulderL)] -= shoulder_l;
  pose[index(Joint::kArmLowerR)] += elbow_r;
  pose[index(Joint::kArmLowerL)] -= elbow_l;
  return pose;
}
// As a robot lies that fell with straight legs.
Pose straight() {
  Pose pose = stance();
  for (std::size_t i = 0; i < kJoints; ++i)
    if (isLeg(static_cast<Joint>(i))) pose[i] = kTickCentre;
  return pose;
}

const std::vector<Fall>& falls() {
  static const std::vector<Fall> kFalls{
      {"as it fell", {}, stance()},
      {"slippery floor", {.floor_friction = 0.8}, stance()},
      {"rough floor", {.floor_friction = 1.2}, stance()},
      {"one arm ahead", {}, armsAt(200, -200, 150, -150)},
      {"weak battery, other arm ahead", {.supply_v = 11.1}, armsAt(-250, 150, -250, 100)},
      {"straight legs", {.floor_friction = 0.9}, straight()},
  };
  return kFalls;
}

void expectUpFrom(bool front, int page) {
  const PageFile pages = ownPages();
  Stage first;
  first.stand();
  const Lying lying = first.pushOver(front);
  ASSERT_LT(std::abs(first.body().upright()), 0.3) << "it should lie";
  for (const Fall& fall : falls()) {
    Stage stage{fall.stage};
    stage.lie(lying, fall.goals);
    ASSERT_LT(std::abs(stage.body().upright()), 0.4) << fall.what;
    const Watched seen = stage.play(pages, page);
    stage.expectStanding(fall.what);
    EXPECT_LT(seen.full_s, 1.2) << fall.what << ", " << seen.full_joint << ": a servo gives up after 2 s";
    EXPECT_LT(seen.mean, 0.6) << fall.what;
    EXPECT_FALSE(seen.overload) << fall.what;
    EXPECT_THAT(seen.touching, testing::IsEmpty()) << fall.what;
  }
}

TEST(GetUp, FromTheFront) {
  expectUpFrom(true, 10);
}

TEST(GetUp, FromTheBack) {
  expectUpFrom(false, 11);
}

}  // namespace
}  // namespace darwinop::motion
