// Plays football alone: looks for a red ball, walks to it, kicks it, and gets up after a fall. Ends after --seconds N,
// or with Ctrl-C. Without a robot, with a ball that lies before it:
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

// Motion pages, by the numbers of the robot's own file.
enum Page { kUpFromFront = 10, kUpFromBack = 11, kKickRight = 12, kKickLeft = 13 };

// m. While it walks its camera is so high above the floor and so far ahead of the feet.
const double kCameraHeight = 0.40, kCameraAhead = 0.08, kBallRadius = 0.04;
// rad below the horizon that the camera looks when the head's angle is 0: 45 degrees, and the trunk leans forwards.
const double kLooksDown = 0.785 + 0.17;
// m: where the ball has to be for a kick, from the middle between the feet, and how well.
const double kKickAhead = 0.13, kKickAside = 0.045, kNearEnough = 0.02;

static double within(double most, double value) {
  return std::max(-most, std::min(most, value));
}

// The ball as the robot thinks of it: m, from the middle between its feet.
struct Ball {
  double ahead = 0, left = 0;
  double seen_at = -10;  // s
  double direction() const { return std::atan2(left, ahead); }
};

class Player : public Robot {
 public:
  Player();
  void play(double end);

 private:
  bool goOn();  // one time step with all that goes with it; false: the end
  bool look();  // for the ball, and after it with the head; true: it is in this picture
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
  int on_front_ = 0, on_back_ = 0, lies_ = 0, stands_ = 0, ready_ = 0;  // steps for which it has been so
  int tries_ = 0;                                                       // to get up, since it stood last
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
      // Hue and tolerance in degrees, least saturation and value in percent; the ball fills 0 to 30 % of the picture.
      vision_(camera_->getWidth(), camera_->getHeight(), 355, 15, 60, 15, 0, 30) {
  camera_->enable(2 * time_step_);  // the camera gives 30 pictures a second
  accelerometer_->enable(time_step_);
}

bool Player::goOn() {
  neck_motor_->setPosition(neck_);
  head_motor_->setPosition(head_);
  gait_.step(time_step_);
  if (step(time_step_) == -1) return false;
  // Lying, gravity is along the axis from back to front, 128 counts from the middle, and not along the height. One step
  // back for each that says no: legs that walk on in the air shake a robot that lies. Silence (NaN) is no fall.
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
  // From pixels to angles, from angles to the place where such a line of sight meets the floor.
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
    if (!goOn()) return false;
  return true;
}

// Turns to the side where the ball was last, and looks up and down.
void Player::search() {
  gait_.setXAmplitude(0);
  gait_.setYAmplitude(0);
  gait_.setAAmplitude(ball_.left < 0 ? -0.3 : 0.3);
  neck_ = 0;
  head_ = 0.3 + 0.6 * std::sin(2 * getTime());
}

// Far away it walks where the ball is; near it, sideways until the ball is before the foot that is closer.
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
  if (getTime() - ball_.seen_at > 0.2 || !isBeforeAFoot()) return gait_.start();  // it has rolled on
  std::cout << "I kick the ball, " << std::lround(100 * ball_.ahead) << " cm ahead and "
            << std::lround(100 * ball_.left) << " to the left." << std::endl;
  motion_.playPage(ball_.left < 0 ? kKickRight : kKickLeft);
  neck_ = 0, head_ = 0.4;  // up, where the ball goes
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

void Player::play(double end) {
  if (!gait_.isCorrectlyInitialized() || !motion_.isCorrectlyInitialized()) return;
  gait_.start();
  while (goOn() && getTime() < end) {
    // On a side, where no page helps, or in somebody's hands.
    if (lies_ > 250 || tries_ > 3) {
      std::cout << "I cannot get up: help me." << std::endl;
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
}

int main(int argc, char** argv) {
  const bool has_end = argc == 3 && std::strcmp(argv[1], "--seconds") == 0;
  if (argc > 1 && !has_end) {  // before anything moves
    std::cerr << "usage: 06_soccer [--seconds N]" << std::endl;
    return EXIT_FAILURE;
  }
  Player player;
  player.play(has_end ? std::atof(argv[2]) : INFINITY);
  return EXIT_SUCCESS;
}
