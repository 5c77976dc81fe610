// A light of the robot: "EyeLed", "HeadLed" (colours), "BackLedRed", "BackLedGreen", "BackLedBlue" (on or off).
#ifndef LED_HPP
#define LED_HPP

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace webots {

///     robot.getLED("EyeLed")->set(0x00FF00);   // green
///     robot.getLED("BackLedRed")->set(1);      // on
///
/// The three back LEDs are on or off; EyeLed and HeadLed have colours. Threads: see Robot.
class LED : public Device {
 public:
  /// The robot's device of this name, for Robot::createLED() and a class of your own; see Device.
  explicit LED(const std::string& name);
  virtual ~LED();
  /// EyeLed, HeadLed: 0 to 0xFFFFFF, 0xRRGGBB, of which the board shows 5 bits per colour; higher bits are ignored.
  /// Back LEDs: 0 is off, any other value is on (2013: 1 only). Shown at the next Robot::step(); LEDs set in one step
  /// do not affect each other (2013: the last one won, and setting an LED again switched it off).
  virtual void set(int value);
  /// The value set last, 0 to 0xFFFFFF (back LEDs: 0 or 1); before the first one, what the board shows.
  /// 2013: the board's own word.
  int get() const;

 private:
  friend class darwinop::webots_api::RobotImpl;
  enum Which { EYE, HEAD, BACK };
  LED(const std::string& name, darwinop::webots_api::RobotImpl& robot, Which which, int panel_bit);
  Which which_;
  int panel_bit_, value_;
  bool set_;
};

}  // namespace webots

#endif
