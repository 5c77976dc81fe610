// Gait on the twin: distances, turning, standing up, pushes. Few long runs, each with several checks.
#include <gmock/gmock.h>

#include <DARwInOPGaitManager.hpp>
#include <RobotisOp2MotionManager.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <webots/Accelerometer.hpp>
#include <webots/Robot.hpp>

#include "connect/lockstep_robot.hpp"
#include "core/units.hpp"
#include "twin/body/robot_body.hpp"
#include "webots/robot_impl.hpp"

namespace managers {
namespace {

namespace webots_api = darwinop::webots_api;
namespace twin = darwinop::twin;
using std::chrono::milliseconds;

class TwinRobot : public webots::Robot {
 public:
  explicit TwinRobot(webots_api::RobotImpl* impl) : Robot(impl) {}
};

class WalkInTheTwin : public testing::Test {
 protected:
  WalkInTheTwin() {
    auto body = std::make_unique<twin::RobotBody>(twin::readModel(twin::findModel("darwin-op")),
                                                  twin::RobotBodyOptions{.ball = twin::Ball::kNone});
    body_ = body.get();
    darwinop::runtime::LoopConfig config;
    auto impl = std::make_unique<webots_api::RobotImpl>(darwinop::connect::lockstepRobot(config, std::move(body)),
                                                        webots_api::ControllerConfig{}, stop_);
    EXPECT_EQ(impl->begin(), "");
    robot_ = std::make_unique<TwinRobot>(impl.release());
    accelerometer_ = robot_->getAccelerometer("Accelerometer");
    accelerometer_->enable(16);
    gait_ = std::make_unique<DARwInOPGaitManager>(robot_.get(), "missing.ini");
  }

  void step(double seconds, bool walking) {
    const double end = robot_->getTime() + seconds;
    while (robot_->getTime() < end) {
      if (walking) gait_->step(16);
      ASSERT_EQ(robot_->step(16), 0);
      lowest_ = std::min(lowest_, body_->upright());
      turned_ += std::remainder(body_->heading() - heading_, 2 * darwinop::kPi);
      heading_ = body_->heading();
      lying_ = accelerometer_->getValues()[2] < 550 ? lying_ + 1 : 0;  // upright: 640
      lying_longest_ = std::max(lying_longest_, lying_);
    }
  }
  /// From the start pose to just before the first step.
  void standUp() {
    gait_->start();
    step(kStance, true);
    from_ = body_->trunkPosition();
  }
  void walk(double seconds, double x, double y, double a) {
    gait_->setXAmplitude(x);
    gait_->setYAmplitude(y);
    gait_->setAAmplitude(a);
    from_ = body_->trunkPosition();
    turned_ = 0;
    step(seconds, true);
  }
  void push(const std::array<double, 3>& newton) { body_->push(newton, kPush); }

  /// Distance since the start of the last walk(), m, in the robot's initial frame: 0 forwards, 1 left.
  [[nodiscard]] double went(std::size_t axis) const { return body_->trunkPosition()[axis] - from_[axis]; }
  [[nodiscard]] double went() const { return std::hypot(went(0), went(1)); }
  [[nodiscard]] double turnedDeg() const { return turned_ / darwinop::kRadPerDegree; }

  static constexpr double kStance = 4.3;  // s: 2.7 approach, 1.6 calibration
  static constexpr milliseconds kPush{100};
  std::atomic<bool> stop_{false};
  twin::RobotBody* body_ = nullptr;
  std::unique_ptr<TwinRobot> robot_;
  webots::Accelerometer* accelerometer_ = nullptr;
  std::unique_ptr<DARwInOPGaitManager> gait_;
  std::array<double, 3> from_{};
  double lowest_ = 1, heading_ = 0, turned_ = 0;
  int lying_ = 0, lying_longest_ = 0;  // consecutive steps without upright gravity
};

// Limits have a margin for changes of the body model; measured values are in comments and in docs/gait.md.
constexpr double kLeans = 0.9;  // 0.96: 16 degrees
constexpr int kGetUpFromFront = 10;
constexpr int kFallen = 30;  // steps, as in 05_walk; not reached without a fall

TEST_F(WalkInTheTwin, StandsUpWalksTurnsAndStops) {
  EXPECT_LT(body_->trunkPosition()[2], 0.26) << "sitting";
  standUp();
  EXPECT_GT(body_->trunkPosition()[2], 0.28);

  walk(30, 1, 0, 0);
  EXPECT_GT(went(0), 0.6 * 0.133 * 30) << "4.0 m by kinematics";  // 4.6
  EXPECT_LT(std::abs(turnedDeg()), 45);                           // 5

  walk(3, 0, 0, 1);
  EXPECT_GT(turnedDeg(), 90);  // 256
  EXPECT_LT(went(), 0.3);      // 0.1

  gait_->stop();
  step(1, false);
  from_ = body_->trunkPosition();
  step(1, false);
  EXPECT_LT(went(), 0.005);
  EXPECT_GT(body_->upright(), 0.97);
  EXPECT_GT(lowest_, kLeans);
  EXPECT_LT(lying_longest_, kFallen);
}

TEST_F(WalkInTheTwin, WalksSidewaysBackwardsAndInPlace) {
  standUp();
  walk(8, 0, 1, 0);
  EXPECT_GT(went(1), 0.2);
  walk(6, -0.5, 0, 0);
  EXPECT_LT(went(0), -0.05);
  walk(6, 0, 0, 0);
  EXPECT_LT(went(), 0.5);
  EXPECT_GT(lowest_, kLeans);
}

TEST_F(WalkInTheTwin, WithstandsASmallPushAndGetsUpAfterALargeOne) {
  standUp();
  walk(3, 1, 0, 0);
  push({8, 0, 0});  // withstands 10 at any time; 12.5 may make it fall
  walk(3, 1, 0, 0);
  push({0, 4, 0});  // 5, and 7.5
  walk(3, 1, 0, 0);
  EXPECT_GT(body_->upright(), kLeans);
  EXPECT_LT(lying_longest_, kFallen) << "no false fall detection";

  push({40, 0, 0});
  walk(3, 1, 0, 0);
  EXPECT_LT(body_->upright(), 0.3) << "lying";
  EXPECT_GE(lying_longest_, kFallen) << "the accelerometer detects it while the legs move";

  RobotisOp2MotionManager pages{robot_.get(), "own"};
  pages.playPage(kGetUpFromFront);
  EXPECT_GT(body_->upright(), 0.95);
  walk(8, 1, 0, 0);
  EXPECT_GT(went(), 0.6 * 0.133 * 5) << "includes the time of the approach";
  EXPECT_GT(body_->upright(), kLeans);
}

}  // namespace
}  // namespace managers
