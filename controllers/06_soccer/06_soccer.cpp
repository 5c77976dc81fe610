// Soccer: searches an orange ball, walks to it, kicks it, and gets up after a fall. Ends after --seconds N, or with
// Ctrl-C. Without a robot, with a ball in front of it:
//
//   DARWINOP_TWIN_BALL=rests darwinop run build/release/controllers/06_soccer --robot twin -- --seconds 60
#include <RobotisOp2GaitManager.hpp>
#include <RobotisOp2MotionManager.hpp>
#include <RobotisOp2VisionManager.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <webots/Accelerometer.hpp>
#include <webots/Camera.hpp>
#include <webots/LED.hpp>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

using namespace webots;

// Motion pages of the robot's motion file.
enum Page { kUpFromFront = 10, kUpFromBack = 11, kKickRight = 12, kKickLeft = 13 };

// m. Camera while walking: height above the floor, distance ahead of the feet.
const double kCameraHeight = 0.40, kCameraAhead = 0.08, kBallRadius = 0.04;
// rad below the horizon at head angle 0: 45 degrees plus the pitch of the trunk.
const double kLooksDown = 0.785 + 0.17;
// m: ball position for a kick, from the middle between the feet, and tolerance.
const double kKickAhead = 0.13, kKickAside = 0.045, kNearEnough = 0.02;

static double within(double most, double value) {
  return std::max(-most, std::min(most, value));
}

// Estimated ball position, m, from the middle between the feet.
struct Ball {
  double ahead = 0, left = 0;
  double seen_at = -10;  // s
  double direction() const { return std::atan2(left, ahead); }
};

class Player : public Robot {
 public:
  Player();
  /// False: it could not, or not any longer.
  bool play(double end);

 private:
  bool advance();  // one time step; false: the end
  bool look();     // updates ball and head; true: the ball is in this picture
  bool wait(double seconds);
  void search();
  void approach();
  bool isBeforeAFoot() const;
  void kick();
  void getUpAfterAFall();

  const int time_step_;
  Camera* camera_;
  Accelerometer* accelerometer_;
  LED* eyes_;
  Motor *neck_motor_, *head_motor_;
  managers::RobotisOp2GaitManager gait_;
  managers::RobotisOp2MotionManager motion_;
  managers::RobotisOp2VisionManager vision_;
  double neck_ = 0, head_ = 0;  // rad
  Ball ball_;
  int on_front_ = 0, on_back_ = 0, lies_ = 0, stands_ = 0, ready_ = 0;  // counters, in steps
  int tries_ = 0;                                                       // attempts to get up
};

Player::Player()
    : time_step_(static_cast<int>(getBasicTimeStep())),
      camera_(getCamera("Camera")),
      accelerometer_(getAccelerometer("Accelerometer")),
      eyes_(getLED("EyeLed")),
      neck_motor_(getMotor("Neck")),
      head_motor_(getMotor("Head")),
      gait_(this, "config.ini"),
      motion_(this),
      // Hue and tolerance in degrees, minimum saturation and value in percent; the ball covers 0 to 30 %.
      vision_(camera_->getWidth(), camera_->getHeight(), 28, 20, 50, 45, 0, 30) {
  camera_->enable(2 * time_step_);  // the camera gives 30 pictures a second
  if (accelerometer_ != nullptr) accelerometer_->enable(time_step_);
}

bool Player::advance() {
  neck_motor_->setPosition(neck_);
  head_motor_->setPosition(head_);
  gait_.step(time_step_);
  if (step(time_step_) == -1) return false;
  // Lying: gravity along the front axis, 128 counts from the centre, not along the vertical one. The counters decrease
  // gradually, because moving legs shake a lying robot. NaN is not a fall.
  const double forwards = accelerometer_->getValues()[1];
  const bool tilted = accelerometer_->getValues()[2] < 512 + 64;
  lies_ = tilted ? lies_ + 1 : 0;
  stands_ = tilted ? 0 : stands_ + 1;
  if (stands_ > 60) tries_ = 0;
  on_front_ = tilted && forwards < 512 - 80 ? on_front_ + 1 : std::max(0, on_front_ - 1);
  on_back_ = tilted && forwards > 512 + 80 ? on_back_ + 1 : std::max(0, on_back_ - 1);
  return true;
}

bool Player::look() {
  double x, y;
  const bool found = vision_.getBallCenter(x, y, camera_->getImage());
  eyes_->set(found ? 0x00FF00 : 0xFF0000);
  if (!found) return false;
  // From pixels to angles, then to the intersection of the line of sight with the floor.
  const double focus = camera_->getWidth() / 2.0 / std::tan(camera_->getFov() / 2);  // pixels
  const double aside = std::atan((camera_->getWidth() / 2.0 - x) / focus);
  const double below = std::atan((y - camera_->getHeight() / 2.0) / focus);
  const double down = std::max(0.1, kLooksDown - head_ + below), left = neck_ + aside;
  const double distance = (kCameraHeight - kBallRadius) / std::tan(down);
  ball_.ahead = kCameraAhead + distance * std::cos(left);
  ball_.left = distance * std::sin(left);
  ball_.seen_at = getTime();
  neck_ = within(1.5, neck_ + 0.1 * aside);
  head_ = std::max(-0.35, std::min(0.9, head_ - 0.1 * below));
  return true;
}

bool Player::wait(double seconds) {
  for (const double end = getTime() + seconds; getTime() < end; look())
    if (!advance()) return false;
  return true;
}

// Turns towards the last position of the ball and moves the head up and down.
void Player::search() {
  gait_.setXAmplitude(0);
  gait_.setYAmplitude(0);
  gait_.setAAmplitude(ball_.left < 0 ? -0.3 : 0.3);
  neck_ -= within(0.03, neck_);  // rad per step: not in one jump
  head_ += within(0.03, 0.3 + 0.6 * std::sin(2 * getTime()) - head_);
}

// Far away: walks towards the ball. Near: steps sideways until the ball is in front of the closer foot.
void Player::approach() {
  const double foot = ball_.left < 0 ? -kKickAside : kKickAside;
  const double ahead = ball_.ahead - kKickAhead;
  const bool near = ahead < 0.1;
  gait_.setXAmplitude(near ? within(0.5, 8 * ahead) : std::min(1.0, 4 * ahead));
  gait_.setYAmplitude(near ? within(1, 15 * (ball_.left - foot)) : 0);
  gait_.setAAmplitude(near ? 0 : within(0.3, ball_.direction()));
}

bool Player::isBeforeAFoot() const {
  return std::abs(ball_.ahead - kKickAhead) < kNearEnough && std::abs(std::abs(ball_.left) - kKickAside) < kNearEnough;
}

void Player::kick() {
  gait_.stop();
  if (!wait(0.5)) return;
  if (getTime() - ball_.seen_at > 0.2 || !isBeforeAFoot()) return gait_.start();  // the ball has moved
  std::cout << "I kick the ball, " << std::lround(100 * ball_.ahead) << " cm ahead and "
            << std::lround(100 * ball_.left) << " to the left." << std::endl;
  motion_.playPage(ball_.left < 0 ? kKickRight : kKickLeft);
  neck_ = 0, head_ = 0.4;  // follow the ball
  if (!wait(1)) return;
  if (getTime() - ball_.seen_at < 0.2)
    std::cout << "It lies " << std::lround(100 * std::hypot(ball_.ahead, ball_.left)) << " cm away now." << std::endl;
  gait_.start();
}

void Player::getUpAfterAFall() {
  const bool on_front = on_front_ > on_back_;
  std::cout << "I fell on my " << (on_front ? "front." : "back.") << std::endl;
  gait_.stop();
  motion_.playPage(on_front ? kUpFromFront : kUpFromBack);
  gait_.start();
  on_front_ = on_back_ = lies_ = 0;
  ++tries_;
}

bool Player::play(double end) {
  if (accelerometer_ == nullptr) {
    std::cerr << "This example needs an accelerometer to detect falls; servos without a board have none." << std::endl;
    return false;
  }
  if (!gait_.isCorrectlyInitialized() || !motion_.isCorrectlyInitialized()) return false;
  bool plays = true;
  gait_.start();
  while (advance() && getTime() < end) {
    // On a side, or being carried.
    if (lies_ > 250 || tries_ > 3) {
      std::cout << "I cannot get up: help me." << std::endl;
      plays = false;
      break;
    }
    if (on_front_ > 20 || on_back_ > 20) getUpAfterAFall();
    look();
    if (getTime() - ball_.seen_at > 1)
      search();
    else
      approach();
    ready_ = isBeforeAFoot() ? ready_ + 1 : 0;
    if (ready_ > 10) kick();
  }
  gait_.stop();
  return plays;
}

int main(int argc, char** argv) {
  char* end = nullptr;
  const double seconds = argc == 3 ? std::strtod(argv[2], &end) : INFINITY;
  const bool has_end = argc == 3 && std::strcmp(argv[1], "--seconds") == 0 && end != argv[2] && *end == '\0';
  if (argc > 1 && !has_end) {  // before the robot moves
    std::cerr << "usage: 06_soccer [--seconds N]" << std::endl;
    return 2;
  }
  Player player;
  return player.play(seconds) ? EXIT_SUCCESS : EXIT_FAILURE;
}
