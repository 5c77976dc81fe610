// Head camera of the twin: ball position in the picture against a pinhole model, picture format, rate, test pattern.
#include "twin/render/head_camera.hpp"

#include <gmock/gmock.h>
#include <mujoco/mujoco.h>

#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>

#include "twin/render/support.hpp"
#include "twin/view/named_poses.hpp"

namespace darwinop::twin {
namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr double kHalfAngle = 1.0123 / 2;  // horizontal, of the robot's camera
constexpr double kPixels = 3;  // the projection of a ball is an ellipse: its centre is off by up to 2 pixels

Spot orangeSpot(const RenderedPicture& p) {
  return centreOf(p, [&](int x, int y) {
    return red(p, x, y) > 60 && 2 * red(p, x, y) > 3 * green(p, x, y) && red(p, x, y) > 3 * blue(p, x, y);
  });
}

/// Expected position of the ball's centre in the picture (pinhole camera).
Spot expected(RobotBody& body) {
  const mjModel& m = *body.mujocoModel();
  mjData& d = *body.mujocoData();
  const int camera = mj_name2id(&m, mjOBJ_CAMERA, "head"), ball = mj_name2id(&m, mjOBJ_BODY, "ball");
  std::array<double, 3> seen{};  // right, up, back
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < 3; ++k)
      seen.at(static_cast<std::size_t>(axis)) +=
          d.cam_xmat[9 * camera + 3 * k + axis] * (d.xpos[3 * ball + k] - d.cam_xpos[3 * camera + k]);
  const double pixels_per_unit = kWidth / 2.0 / std::tan(kHalfAngle);
  return {kWidth / 2.0 + pixels_per_unit * seen[0] / -seen[2] - 0.5,
          kHeight / 2.0 - pixels_per_unit * seen[1] / -seen[2] - 0.5, 0};
}

class HeadCameraTest : public testing::Test {
 protected:
  /// Places ball and robot and takes a picture.
  Spot look(double ball_x, double ball_y, double neck_rad = 0) {
    Angles angles = startAngles();
    angles[index(Joint::kNeck)] = neck_rad;
    body_.place(angles);
    body_.placeBall(ball_x, ball_y);
    body_.step(std::chrono::milliseconds{34}, Drives{});  // one picture period later
    mj_forward(body_.mujocoModel(), body_.mujocoData());
    if (!camera_) camera_ = std::make_unique<HeadCamera>(body_);  // the slow part of a test
    camera_->look();
    (void)camera_->newest();
    EXPECT_EQ(camera_->renderError(), nullptr);
    return orangeSpot(camera_->picture());
  }

  RobotBody body_ = usualBody();
  std::unique_ptr<HeadCamera> camera_;
};

TEST_F(HeadCameraTest, ShowsTheBallWhereThePinholeModelPredicts) {
  for (const auto& [x, y] : {std::pair{0.4, 0.0}, {0.45, 0.12}, {0.5, -0.1}, {0.35, 0.0}}) {
    const Spot seen = look(x, y), wanted = expected(body_);
    EXPECT_GT(seen.pixels, 200) << x << ' ' << y;
    EXPECT_NEAR(seen.x, wanted.x, kPixels) << x << ' ' << y;
    EXPECT_NEAR(seen.y, wanted.y, kPixels) << x << ' ' << y;
  }
}

TEST_F(HeadCameraTest, ABallOnTheLeftIsLeftAndAFarOneIsHigher) {
  const Spot ahead = look(0.4, 0), left = look(0.4, 0.1), far = look(0.55, 0);
  EXPECT_LT(left.x, ahead.x - 30);  // 0.1 m at half a metre are 55 pixels
  EXPECT_LT(far.y, ahead.y - 15);   // rows count downward
}

TEST_F(HeadCameraTest, TurningTheHeadLeftMovesTheBallRight) {
  const Spot ahead = look(0.45, 0), turned = look(0.45, 0, 0.2);
  EXPECT_GT(turned.x, ahead.x + 30);
  EXPECT_NEAR(turned.x, expected(body_).x, kPixels);
}

TEST_F(HeadCameraTest, BytesAreBlueGreenRedWithTheTopRowFirst) {
  look(0.45, 0.05);
  const HeadCamera& camera = *camera_;
  const CameraFrame frame = camera_->newest();
  ASSERT_EQ(frame.bgra.size(), 4U * kWidth * kHeight);
  for (const auto& [x, y] : {std::pair{0, 0}, {319, 0}, {100, 60}, {160, 120}, {0, 239}}) {
    const std::uint8_t* const pixel = frame.bgra.data() + 4 * (y * kWidth + x);
    EXPECT_EQ(pixel[0], blue(camera.picture(), x, y));
    EXPECT_EQ(pixel[1], green(camera.picture(), x, y));
    EXPECT_EQ(pixel[2], red(camera.picture(), x, y));
    EXPECT_EQ(pixel[3], 255);
  }
}

TEST_F(HeadCameraTest, ReturnsThirtyDifferentPicturesPerSecond) {
  HeadCamera camera{body_, {.width = 32, .height = 24}};
  const Drives limp{};
  std::uint64_t pictures = 0, last = 0;
  for (int cycle = 0; cycle < 63; ++cycle) {  // 1 s in cycles of 16 ms
    camera.look();
    const CameraFrame frame = camera.newest();
    if (frame.sequence != last) ++pictures;
    EXPECT_LE(frame.sequence, last + 1);
    last = frame.sequence;
    body_.step(std::chrono::milliseconds{16}, limp);
  }
  EXPECT_NEAR(static_cast<double>(pictures), 30, 1);
  body_.step(std::chrono::milliseconds{200}, limp);
  camera.look();
  EXPECT_NEAR(static_cast<double>(camera.newest().sequence - last), 6, 1);  // five were not requested
}

TEST_F(HeadCameraTest, LookingDoesNotChangeTheSimulation) {
  RobotBody unseen = usualBody();
  HeadCamera camera{body_, {.width = 32, .height = 24}};
  const Drives limp{};
  for (int i = 0; i < 30; ++i) {
    body_.step(std::chrono::milliseconds{10}, limp);
    unseen.step(std::chrono::milliseconds{10}, limp);
    camera.look();
    (void)camera.newest();
  }
  const int count = body_.mujocoModel()->nq;
  for (int i = 0; i < count; ++i) EXPECT_EQ(body_.mujocoData()->qpos[i], unseen.mujocoData()->qpos[i]);
}

TEST_F(HeadCameraTest, WithoutOpenGlTheTestPatternContainsTheReason) {
  const Environment none{"DARWINOP_TWIN_GL", "off"};
  testing::internal::CaptureStderr();
  HeadCamera camera{body_}, second{body_};
  camera.look();
  const CameraFrame frame = camera.newest();
  second.look();
  (void)second.newest();
  const std::string logged = testing::internal::GetCapturedStderr();
  EXPECT_THAT(logged, testing::HasSubstr(camera.renderError()));
  EXPECT_EQ(std::count(logged.begin(), logged.end(), '\n'), 1) << logged;  // once for both
  EXPECT_THAT(camera.renderError(), testing::HasSubstr("DARWINOP_TWIN_GL"));
  EXPECT_FALSE(camera.health().seeing) << "a test pattern must not be used by controllers";

  EXPECT_EQ(frame.sequence, 1U);
  const RenderedPicture& p = camera.picture();
  EXPECT_EQ((std::array{red(p, 60, 10), green(p, 60, 10), blue(p, 60, 10)}), (std::array{255, 255, 0}));
  EXPECT_EQ((std::array{red(p, 260, 10), green(p, 260, 10), blue(p, 260, 10)}), (std::array{0, 0, 255}));
}

TEST_F(HeadCameraTest, AnInvalidSizeIsRefused) {
  EXPECT_THROW((HeadCamera{body_, {.width = 0, .height = 240}}), std::runtime_error);
  EXPECT_THROW((HeadCamera{body_, {.width = 320, .height = 100000}}), std::runtime_error);
}

}  // namespace
}  // namespace darwinop::twin
