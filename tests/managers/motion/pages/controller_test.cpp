// Built-in pages played by a controller through motion manager, safety layer and bus: getting up after a push.
#include <gmock/gmock.h>

#include <RobotisOp2MotionManager.hpp>
#include <atomic>
#include <memory>
#include <webots/Robot.hpp>

#include "connect/lockstep_robot.hpp"
#include "managers/motion/pages/promised_poses.hpp"
#include "twin/body/robot_body.hpp"
#include "webots/robot_impl.hpp"

namespace darwinop::motion {
namespace {

class TwinRobot : public webots::Robot {
 public:
  explicit TwinRobot(webots_api::RobotImpl* impl) : Robot(impl) {}
};

TEST(ThroughTheManager, ThePushedRobotGetsUpFromBothSidesAndSitsDown) {
  auto made = std::make_unique<twin::RobotBody>(twin::readModel(twin::findModel("darwin-op")),
                                                twin::RobotBodyOptions{.ball = twin::Ball::kNone});
  twin::RobotBody& body = *made;
  std::atomic<bool> stop{false};
  auto impl = std::make_unique<webots_api::RobotImpl>(connect::lockstepRobot({}, std::move(made)),
                                                      webots_api::ControllerConfig{}, stop);
  ASSERT_EQ(impl->begin(), "");
  TwinRobot robot{impl.release()};
  managers::RobotisOp2MotionManager pages{&robot, "own"};
  ASSERT_TRUE(pages.isCorrectlyInitialized());
  const auto steps = [&](double seconds) {
    for (double t = 0; t < seconds; t += 0.016) robot.step(16);
  };

  pages.playPage(9);
  steps(0.5);
  EXPECT_GT(body.upright(), 0.95);
  for (const int side : {1, -1}) {  // to the front, to the back
    for (int i = 0; i < 150 && body.upright() > 0.7; ++i) {
      body.push({side * 20.0, 0, 0}, Nanos{16'000'000});
      robot.step(16);
    }
    steps(2);
    EXPECT_LT(body.upright(), 0.3);
    pages.playPage(side == 1 ? 10 : 11);
    steps(0.5);
    EXPECT_GT(body.upright(), 0.95) << (side == 1 ? "front" : "back");
    EXPECT_NEAR(body.trunkPosition()[2], 0.317, 0.006);
  }
  pages.playPage(15);
  steps(0.5);
  EXPECT_GT(body.upright(), 0.97);
  EXPECT_NEAR(body.trunkPosition()[2], 0.234, 0.006);
}

}  // namespace
}  // namespace darwinop::motion
