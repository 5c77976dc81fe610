// Offscreen rendering of the robot, PNG files, lettering, test pattern.
#include <gmock/gmock.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "support/temporary_folder.hpp"
#include "twin/render/lettering.hpp"
#include "twin/render/offscreen.hpp"
#include "twin/render/png.hpp"
#include "twin/render/support.hpp"
#include "twin/render/test_pattern.hpp"
#include "twin/view/named_poses.hpp"

namespace darwinop::twin {
namespace {

constexpr int kColumns = 160, kRows = 120;

/// Pixels of the robot: difference to a picture without it, rendered without shadows.
struct Silhouette {
  RenderedPicture with, without;

  Silhouette(Offscreen& offscreen, RobotBody& body, Viewpoint from) {
    Pose pose = poseOf(body);
    offscreen.scene().show(pose);
    offscreen.scene().lookFrom(from);
    with = offscreen.draw();
    const mjModel& m = *body.mujocoModel();
    const int joint = m.body_jntadr[mj_name2id(&m, mjOBJ_BODY, "Body")];
    pose.qpos.at(static_cast<std::size_t>(m.jnt_qposadr[joint]) + 2) = -5;  // under the floor
    offscreen.scene().show(pose);
    without = offscreen.draw();
  }

  [[nodiscard]] bool robot(int x, int y) const {
    return !std::equal(with.at(x, y), with.at(x, y) + 3, without.at(x, y));
  }
  [[nodiscard]] Spot centre() const {
    return centreOf(with, [this](int x, int y) { return robot(x, y); });
  }
  [[nodiscard]] int top() const {
    for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kColumns; ++x)
        if (robot(x, y)) return y;
    return kRows;
  }
};

class Drawing : public testing::Test {
 protected:
  RobotBody body_ = usualBody();
  Offscreen offscreen_{*body_.mujocoModel(), kColumns, kRows, Quality::kEye};
};

TEST_F(Drawing, ShowsTheKneelingRobotInTheMiddle) {
  for (const Viewpoint from : {Viewpoint::kFollow, Viewpoint::kSide, Viewpoint::kFront}) {
    const Silhouette seen{offscreen_, body_, from};
    EXPECT_TRUE(seen.robot(kColumns / 2, kRows / 2 + 5));
    EXPECT_NEAR(seen.centre().x, kColumns / 2.0, kColumns / 8.0);
    EXPECT_NEAR(seen.centre().y, kRows / 2.0, kRows / 5.0);
    EXPECT_GT(seen.centre().pixels, kColumns * kRows / 50);
    EXPECT_LT(seen.centre().pixels, kColumns * kRows / 4);
  }
}

TEST_F(Drawing, HasTheSkyAboveAndTheFloorBelow) {
  const Silhouette seen{offscreen_, body_, Viewpoint::kSide};
  EXPECT_GT(blue(seen.with, 5, 1), green(seen.with, 5, 1));
  EXPECT_GT(green(seen.with, 5, kRows - 2), blue(seen.with, 5, kRows - 2));
}

TEST_F(Drawing, AStandingRobotReachesHigherThanAKneelingOne) {
  const int kneeling = Silhouette{offscreen_, body_, Viewpoint::kSide}.top();
  body_.place(standingAngles());
  const int standing = Silhouette{offscreen_, body_, Viewpoint::kSide}.top();
  EXPECT_LT(standing, kneeling - kRows / 15);  // 0.12 m of about 0.65 m in the picture's height
}

TEST_F(Drawing, FollowsTheRobot) {
  const Silhouette here{offscreen_, body_, Viewpoint::kFollow};
  const mjModel& m = *body_.mujocoModel();
  body_.mujocoData()->qpos[m.jnt_qposadr[m.body_jntadr[mj_name2id(&m, mjOBJ_BODY, "Body")]]] += 3;
  const Silhouette there{offscreen_, body_, Viewpoint::kFollow};
  EXPECT_NEAR(there.centre().x, here.centre().x, 1);
  EXPECT_NEAR(there.centre().y, here.centre().y, 1);
}

TEST_F(Drawing, OfTheSamePoseIsTheSame) {
  offscreen_.scene().show(poseOf(body_));
  const RenderedPicture first = offscreen_.draw();
  EXPECT_EQ(first.rgb, offscreen_.draw().rgb);
}

TEST(RenderedPicture, GoesIntoAPngAndBack) {
  const TemporaryFolder folder;
  RenderedPicture picture = testPattern(33, 17, "why");
  writePng(folder / "p.png", picture);
  const RenderedPicture read = readPng(folder / "p.png");
  EXPECT_EQ(read.width, 33);
  EXPECT_EQ(read.height, 17);
  EXPECT_EQ(read.rgb, picture.rgb);
  try {
    writePng(folder / "none/p.png", picture);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("none/p.png: " + std::string{std::strerror(ENOENT)}));
  }
}

TEST(Lettering, BreaksLinesAtSpacesAndStaysInThePicture) {
  RenderedPicture picture{26, 16};  // four letters per line
  std::ranges::fill(picture.rgb, std::uint8_t{128});
  write(picture, 1, 0, 25, 1, "II II");
  const auto black = [&](int x, int y) { return red(picture, x, y) == 0 && x > 0; };
  // The letter I has its stem in its third column.
  for (const int row : {3, 11})
    for (const int column : {3, 9}) EXPECT_TRUE(black(column, row)) << column << ' ' << row;
  EXPECT_FALSE(red(picture, 4, 3) == 0);
  write(picture, -4, -4, 100, 3, "outside");
}

TEST(TestPattern, HasAMovingMark) {
  EXPECT_NE(testPattern(64, 48, "", 0).rgb, testPattern(64, 48, "", 1).rgb);
}

}  // namespace
}  // namespace darwinop::twin
