// The head follows an orange ball. Eyes green: ball detected; red: searching. Ends after --seconds N, or with Ctrl-C.
// Without a robot, with a moving ball:
//
//   DARWINOP_TWIN_BALL=circles darwinop run build/release/controllers/04_visual_tracking --robot twin -- --seconds 20
#include <RobotisOp2VisionManager.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <webots/Camera.hpp>
#include <webots/LED.hpp>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

using namespace webots;

// Value of "--seconds 10"; infinity without arguments.
static double secondsToRun(int argc, char** argv) {
  if (argc == 1) return INFINITY;
  char* end = nullptr;
  const double seconds = argc == 3 ? std::strtod(argv[2], &end) : 0;
  if (argc == 3 && std::strcmp(argv[1], "--seconds") == 0 && end != argv[2] && *end == '\0') return seconds;
  std::fprintf(stderr, "usage: 04_visual_tracking [--seconds N]\n");
  std::exit(2);
}

// One joint of the head, clamped to its range.
class HeadJoint {
 public:
  explicit HeadJoint(Motor* motor) : motor_(motor) {}
  void turnTo(double angle) {
    angle_ = std::max(motor_->getMinPosition(), std::min(motor_->getMaxPosition(), angle));
    motor_->setPosition(angle_);
  }
  void turnBy(double angle) { turnTo(angle_ + angle); }
  // By at most 0.02 rad: 1.25 rad/s, called every 16 ms.
  void turnTowards(double angle) { turnBy(std::max(-0.02, std::min(0.02, angle - angle_))); }
  double angle() const { return angle_; }

 private:
  Motor* motor_;
  double angle_ = 0;
};

int main(int argc, char** argv) {
  const double end = secondsToRun(argc, argv);
  Robot robot;
  const int time_step = static_cast<int>(robot.getBasicTimeStep());
  Camera* camera = robot.getCamera("Camera");
  camera->enable(2 * time_step);       // the camera gives 30 pictures a second
  LED* eyes = robot.getLED("EyeLed");  // null on servos without a board
  HeadJoint neck(robot.getMotor("Neck")), head(robot.getMotor("Head"));

  // Hue and tolerance in degrees, minimum saturation and value in percent; the ball covers 0 to 30 % of the picture.
  managers::RobotisOp2VisionManager vision(camera->getWidth(), camera->getHeight(), 28, 20, 50, 45, 0, 30);

  const double kGain = 0.1;  // rad per step and picture width: 3 rad/s for a ball at the edge
  double last_seen = 0;
  long steps = 0, seen = 0;
  while (robot.step(time_step) != -1 && robot.getTime() < end) {
    double x, y;
    const bool found = vision.getBallCenter(x, y, camera->getImage());
    ++steps;
    if (eyes != nullptr) eyes->set(found ? 0x00FF00 : 0xFF0000);
    if (found) {
      ++seen;
      last_seen = robot.getTime();
      neck.turnBy(-kGain * (x / camera->getWidth() - 0.5));
      head.turnBy(-kGain * (y / camera->getHeight() - 0.5));
    } else if (robot.getTime() > last_seen + 1) {  // search after 1 s without the ball
      const double t = robot.getTime() - last_seen - 1;
      neck.turnTowards(0.8 * std::sin(t));
      head.turnTowards(0.3 * std::cos(t / 3));
    }
    if (steps % 62 == 0)
      std::cout << (found ? "I see the ball" : "No ball") << ", the neck is at "
                << std::lround(neck.angle() * 180 / M_PI) << " degrees, the head at "
                << std::lround(head.angle() * 180 / M_PI) << std::endl;
  }
  if (steps > 0) std::cout << "The ball was in view " << 100 * seen / steps << " % of the time." << std::endl;
  return EXIT_SUCCESS;
}
