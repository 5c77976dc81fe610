// Getting up: from either side, on slippery and rough floors, with arms where a fall has left them, on a weak battery.
#include <gmock/gmock.h>

#include <cstdlib>
#include <iostream>
#include <random>

#include "managers/motion/pages/own_pages.hpp"
#include "managers/motion/pages/stage.hpp"

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
      {"slippery floor", {.floor_friction = 0.6}, stance()},
      {"rough floor", {.floor_friction = 1.4}, stance()},
      {"one arm ahead", {}, armsAt(200, -200, 150, -150)},
      {"weak battery, other arm ahead", {.supply_v = 11.1}, armsAt(-250, 150, -250, 100)},
      {"the simulator's servos and trunk", {.model = "webots-2013"}, stance()},
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

// DARWINOP_FALLS: how many on each side. DARWINOP_SEED: other ones.
std::uint32_t number(const char* variable, std::uint32_t otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10));
}

// Any floor, any battery, arms up to 60 degrees from where the stance has them while it falls. Measured:
// docs/motions.md.
TEST(GetUp, FromRandomFalls) {
  const PageFile pages = ownPages();
  const std::uint32_t falls = number("DARWINOP_FALLS", 1), seed = number("DARWINOP_SEED", 1);
  std::mt19937 dice{seed};
  const auto within = [&dice](double low, double high) {
    return low + (high - low) * static_cast<double>(dice() >> 8) / 0x1p24;
  };
  for (const bool front : {true, false}) {
    std::uint32_t lay = 0, up = 0, later = 0;
    for (std::uint32_t i = 0; i < falls; ++i) {
      Stage stage{{.floor_friction = within(0.75, 1.25), .supply_v = within(10.6, 12.4)}};
      Pose arms = stance();
      for (std::size_t j = 0; j < index(Joint::kPelvYR); ++j) {
        constexpr double kFarthest = 683;  // ticks, 60 degrees
        const int asked = arms[j] + static_cast<int>(within(-kFarthest, kFarthest));
        arms[j] = std::clamp<int>(asked, kJointTable[j].low, kJointTable[j].high);
      }
      stage.stand(arms);
      (void)stage.pushOver(front, within(-3, 3));
      if (std::abs(stage.body().upright()) > 0.5) continue;  // it leans on an arm
      ++lay;
      stage.play(pages, stage.liesOnFront() ? 10 : 11);
      if (stage.stands()) {
        ++up;
      } else {  // as a controller would
        stage.play(pages, stage.liesOnFront() ? 10 : 11);
        if (stage.stands()) ++later;
      }
    }
    std::cout << (front ? "front: " : "back: ") << up << " of " << lay << " stand, " << later
              << " more after another page\n";
    EXPECT_GE(up * 20, lay * 19) << "seed " << seed << ": one in twenty may not";
    EXPECT_EQ(up + later, lay) << "seed " << seed;
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
