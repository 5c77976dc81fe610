// A light of the robot: "EyeLed", "HeadLed" (colours), "BackLedRed", "BackLedGreen", "BackLedBlue" (on or off).
#ifndef LED_HPP
#define LED_HPP

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace webots {

class LED : public Device {
 public:
  virtual ~LED();
  /// 0xRRGGBB for a colour, 0 for off and anything else for on. Shown with the next Robot::step().
  virtual void set(int value);
  /// Value given last (back LEDs: 0 or 1); before the first one, what the board shows.
  int get() const;

 private:
  friend class darwinop::facade::RobotImpl;
  enum Which { EYE, HEAD, BACK };
  LED(const std::string& name, darwinop::facade::RobotImpl& robot, Which which, int panel_bit);
  Which which_;
  int panel_bit_, value_;
  bool set_;
};

}  // namespace webots

#endif
