// Keys pressed by a person, in a window or in the controller's terminal: docs/keyboard.md.
#ifndef KEYBOARD_HPP
#define KEYBOARD_HPP

namespace darwinop {
namespace webots_api {
class KeyQueue;
class RobotImpl;
}  // namespace webots_api
}  // namespace darwinop

namespace webots {

///     keyboard->enable(16);                                        // ms
///     for (int key; (key = keyboard->getKey()) != -1;)             // after each step
///       if ((key & webots::Keyboard::KEY) == webots::Keyboard::UP) forwards();
///
/// Key codes: letters as capitals (ASCII), the codes below, F1 and the like with codes of this library; SHIFT, CONTROL
/// and ALT are added as bits. Simulator: keys of its 3D window. Threads: see Robot.
class Keyboard {
 public:
  /// Codes of keys without a character, the mask of the code, and modifier bits (2013: no modifiers, no numeric pad).
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

  /// The keyboard of the robot of this process: all calls act on Robot::getKeyboard(). Without a robot they have no
  /// effect, with one warning. 2013: no such class.
  Keyboard();
  virtual ~Keyboard();
  /// Opens a small window, or without a display uses the controller's terminal (DARWINOP_KEYS: window, terminal, none).
  /// Keys are sampled every `sampling_period` ms at the end of a step. 0 or less: disable(). Without window and
  /// terminal it logs one warning, and no key is ever pressed. 2013: crashed without a display.
  virtual void enable(int sampling_period);
  /// Closes the window, or restores the terminal.
  virtual void disable();
  /// ms as set last; 0: disabled.
  int getSamplingPeriod() const;
  /// The next key of the newest sample: each key that was down then, or was pressed since the sample before, once, as a
  /// code with modifier bits. -1: no more keys. All keys are up when the window loses the focus (2013: they stayed
  /// down).
  int getKey() const;

 private:
  friend class darwinop::webots_api::RobotImpl;
  explicit Keyboard(darwinop::webots_api::RobotImpl& robot);
  Keyboard(const Keyboard&);
  Keyboard& operator=(const Keyboard&);
  void refresh(double time_s);
  Keyboard* ofRobot() const;
  darwinop::webots_api::RobotImpl* robot_;  // NULL: made by a controller
  int period_;
  double due_s_;
  darwinop::webots_api::KeyQueue* queue_;  // NULL: disabled
};

}  // namespace webots

#endif
