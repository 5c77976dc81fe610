// Keys pressed by a person, in a window or in the controller's terminal: docs/keyboard.md.
#ifndef KEYBOARD_HPP
#define KEYBOARD_HPP

namespace darwinop {
namespace facade {
class KeyQueue;
class RobotImpl;
}  // namespace facade
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

  virtual ~Keyboard();
  /// Opens the window, or the terminal where there can be none. Keys are looked at every so many ms, at the end of a
  /// step. 0: disable().
  virtual void enable(int sampling_period);
  virtual void disable();
  int getSamplingPeriod() const { return period_; }
  /// The next one of the keys that were down when they were looked at last, or went down since the time before; each
  /// once, with SHIFT, CONTROL and ALT or-ed. -1: that was all.
  int getKey() const;

 private:
  friend class darwinop::facade::RobotImpl;
  explicit Keyboard(darwinop::facade::RobotImpl& robot);
  Keyboard(const Keyboard&);
  Keyboard& operator=(const Keyboard&);
  void refresh(double time_s);
  darwinop::facade::RobotImpl& robot_;
  int period_;
  double due_s_;
  darwinop::facade::KeyQueue* queue_;  // NULL: disabled
};

}  // namespace webots

#endif
