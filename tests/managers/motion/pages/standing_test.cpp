// Pages that begin and end on the feet, on a body that can fall.
#include <gmock/gmock.h>

#include "managers/motion/pages/own_pages.hpp"
#include "managers/motion/pages/stage.hpp"

namespace darwinop::motion {
namespace {

using testing::IsEmpty;

constexpr int kInit = 1, kOk = 2, kNo = 3, kHi = 4, kWalkReady = 9, kRightKick = 12, kLeftKick = 13, kSitDown = 15,
              kStandUp = 16, kHello = 24, kByeBye = 38;

// What no gesture comes near: they are to be played a thousand times.
void expectEasy(const Watched& seen, const std::string& what) {
  EXPECT_LT(seen.peak, 0.75) << what;
  EXPECT_LT(seen.mean, 0.35) << what;
  EXPECT_EQ(seen.full_s, 0) << what << ' ' << seen.full_joint;
  EXPECT_GT(seen.lowest, 0.6) << what;  // a bow
  EXPECT_THAT(seen.touching, IsEmpty()) << what;
}

TEST(Standing, EveryGestureEndsInTheStanceWhereItBegan) {
  const PageFile pages = ownPages();
  Stage stage;
  stage.stand();
  for (const int page : {kInit, kOk, kNo, kHi, kWalkReady, kHello, kByeBye}) {
    const std::string what = "page " + std::to_string(page);
    const std::array<double, 3> before = stage.body().trunkPosition();
    expectEasy(stage.play(pages, page, 0.4), what);
    stage.expectStanding(what);
    EXPECT_LT(std::hypot(stage.body().trunkPosition()[0] - before[0], stage.body().trunkPosition()[1] - before[1]),
              0.02)
        << what;
  }
}

TEST(Standing, SitsDownAndStandsUpInEachWayThereIs) {
  const PageFile pages = ownPages();
  Stage stage;
  stage.sit();
  for (const int page : {kInit, kWalkReady, kStandUp}) {
    const std::string what = "page " + std::to_string(page) + " from sitting";
    expectEasy(stage.play(pages, page), what);
    stage.expectStanding(what);
    expectEasy(stage.play(pages, kSitDown), "sitting down");
    stage.expectSitting("after " + what);
  }
}

// Measured: 1.66 m. The ball lies as far from the toe as a robot stops before it, and not quite in the middle.
TEST(Standing, AKickSendsTheBallForwardsAndEndsInTheStance) {
  struct Kick {
    int page;
    const char* foot;
    double gap, aside, friction;  // m
  };
  constexpr double kToe = 0.0525, kBall = 0.04;  // m: from the foot's middle; radius
  const PageFile pages = ownPages();
  for (const Kick& kick : {Kick{kRightKick, "FootR_1", 0.02, 0, 1}, Kick{kRightKick, "FootR_1", 0.04, 0.02, 0.8},
                           Kick{kLeftKick, "FootL_1", 0.02, 0, 1}, Kick{kLeftKick, "FootL_1", 0, 0.02, 1.2}}) {
    const std::string what = "page " + std::to_string(kick.page);
    Stage stage{{.floor_friction = kick.friction, .ball = true}};
    stage.stand();
    const std::array<double, 2> foot = stage.placeOf(kick.foot);
    const double x = foot[0] + kToe + kBall + kick.gap;
    stage.body().placeBall(x, foot[1] + kick.aside);
    const Watched seen = stage.play(pages, kick.page);
    stage.expectStanding(what);
    EXPECT_GT(stage.placeOf("ball")[0] - x, 0.8) << what;
    EXPECT_LT(std::abs(stage.placeOf("ball")[1] - foot[1]), 0.3) << what;
    EXPECT_GT(seen.lowest, 0.93) << what;
    EXPECT_LT(seen.full_s, 0.3) << what << ' ' << seen.full_joint;
    EXPECT_LT(seen.mean, 0.45) << what;
    EXPECT_THAT(seen.touching, IsEmpty()) << what;
  }
}

}  // namespace
}  // namespace darwinop::motion
