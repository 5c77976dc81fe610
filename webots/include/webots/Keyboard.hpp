// Keys pressed by a person. This version has no keys yet: nothing is ever pressed.
#ifndef KEYBOARD_HPP
#define KEYBOARD_HPP

namespace darwinop {
namespace facade {
class RobotImpl;
}
}  // namespace darwinop

namespace webots {

class Keyboard {
 public:
  enum {
    END = 312,
    HOME = 313,
    LEFT = 314,
    UP = 315,
    RIGHT = 316,
    DOWN = 317,
    PAGEUP = 366,
    PAGEDOWN = 367,
    NUMPAD_HOME = 375,
    NUMPAD_LEFT = 376,
    NUMPAD_UP = 377,
    NUMPAD_RIGHT = 378,
    NUMPAD_DOWN = 379,
    NUMPAD_END = 382,
    KEY = 0x0000FFFF,
    SHIFT = 0x00010000,
    CONTROL = 0x00020000,
    ALT = 0x00040000
  };

  virtual ~Keyboard() {}
  virtual void enable(int sampling_period);
  virtual void disable();
  int getSamplingPeriod() const { return period_; }
  /// Next key pressed since the last step; -1: no more.
  int getKey() const;

 private:
  friend class darwinop::facade::RobotImpl;
  Keyboard() : period_(0) {}
  Keyboard(const Keyboard&);
  Keyboard& operator=(const Keyboard&);
  int period_;
};

}  // namespace webots

#endif
