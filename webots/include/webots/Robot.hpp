// The robot a controller drives. Derive from it or make one; there is one per process.
#ifndef ROBOT_HPP
#define ROBOT_HPP

// Controllers written since 2013 lean on what this header brings along.
#include <pthread.h>
#include <sys/time.h>

#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace darwinop {
namespace facade {
class RobotImpl;
}
}  // namespace darwinop

namespace webots {

class Accelerometer;
class Camera;
class Device;
class Gyro;
class Keyboard;
class LED;
class Motor;
class PositionSensor;
class Servo;
class Speaker;
class TouchSensor;

class Robot {
 public:
  enum Mode { MODE_SIMULATION = 0, MODE_CROSS_COMPILATION = 1, MODE_REMOTE_CONTROL = 2 };
  enum UserInputEvent {
    EVENT_QUIT = -1,
    EVENT_NO_EVENT = 0,
    EVENT_MOUSE_CLICK = 1,
    EVENT_MOUSE_MOVE = 2,
    EVENT_KEYBOARD = 4,
    EVENT_JOYSTICK_BUTTON = 8,
    EVENT_JOYSTICK_AXIS = 16,
    EVENT_JOYSTICK_POV = 32
  };
  enum {  // keys, as in 2013; today they are those of Keyboard
    KEYBOARD_END = 312,
    KEYBOARD_HOME = 313,
    KEYBOARD_LEFT = 314,
    KEYBOARD_UP = 315,
    KEYBOARD_RIGHT = 316,
    KEYBOARD_DOWN = 317,
    KEYBOARD_PAGEUP = 366,
    KEYBOARD_PAGEDOWN = 367,
    KEYBOARD_NUMPAD_HOME = 375,
    KEYBOARD_NUMPAD_LEFT = 376,
    KEYBOARD_NUMPAD_UP = 377,
    KEYBOARD_NUMPAD_RIGHT = 378,
    KEYBOARD_NUMPAD_DOWN = 379,
    KEYBOARD_NUMPAD_END = 382,
    KEYBOARD_KEY = 0x0000FFFF,
    KEYBOARD_SHIFT = 0x00010000,
    KEYBOARD_CONTROL = 0x00020000,
    KEYBOARD_ALT = 0x00040000
  };

  /// Goes to the directory of the program, reads config.ini there, finds the robot, and moves it slowly to its start
  /// pose. Prints a sentence and ends the program when that fails.
  Robot();
  virtual ~Robot();

  /// Sends what was asked of the devices, waits until `duration` ms after the previous step, reads all sensors.
  /// 0: in time. Positive: this many ms late. -1: end the program (Ctrl-C, SIGTERM, a fault, the robot is gone).
  virtual int step(int duration);
  /// The two halves of step(): send; wait and read. Between them the controller may compute.
  virtual int stepBegin(int duration);
  virtual int stepEnd();

  std::string getName() const;
  std::string getModel() const;
  /// Seconds since the robot stood ready; goes on between steps.
  double getTime() const;
  Mode getMode() const { return MODE_CROSS_COMPILATION; }
  int getType() const;
  /// ms, time_step of config.ini; 16 when it is not there.
  double getBasicTimeStep() const;

  // NULL: no such device.
  Accelerometer* getAccelerometer(const std::string& name) const;
  Camera* getCamera(const std::string& name) const;
  Gyro* getGyro(const std::string& name) const;
  Keyboard* getKeyboard() const;
  LED* getLED(const std::string& name) const;
  Motor* getMotor(const std::string& name) const;
  PositionSensor* getPositionSensor(const std::string& name) const;
  Servo* getServo(const std::string& name) const;
  Speaker* getSpeaker(const std::string& name) const;
  /// "ButtonMode" and "ButtonStart".
  TouchSensor* getTouchSensor(const std::string& name) const;
  Device* getDevice(const std::string& name) const;
  int getNumberOfDevices() const;
  Device* getDeviceByIndex(int index) const;

  /// The battery's voltage in V (the simulator gives joules). NaN: the board has not answered for 3 cycles.
  virtual void batterySensorEnable(int sampling_period);
  virtual void batterySensorDisable();
  int batterySensorGetSamplingPeriod() const;
  double batterySensorGetValue() const;

  // Keyboard as in 2013; 0: no key.
  virtual void keyboardEnable(int sampling_period);
  virtual void keyboardDisable();
  int keyboardGetKey() const;

  /// The robot of this process; NULL before its constructor has ended.
  static Robot* getInstance();
  std::string getProjectPath() const;
  std::string getCustomData() const;
  void setCustomData(const std::string& data);
  std::string getData() const;
  void setData(const std::string& data);

  // Of the simulator only. Each says once that it has no effect here.
  std::string getWorldPath() const;
  std::string getUrdf(std::string prefix = "") const;
  bool getSupervisor() const { return false; }
  bool getSynchronization() const { return false; }
  virtual void setMode(Mode mode, const char* arg);
  UserInputEvent waitForUserInputEvent(UserInputEvent event_type, int timeout);
  void wwiSend(const char* data, int size);
  void wwiSendText(const std::string& text);
  const char* wwiReceive(int* size);
  std::string wwiReceiveText();

 protected:
  /// For tests: a robot made elsewhere, which this object then owns.
  explicit Robot(darwinop::facade::RobotImpl* impl);

 private:
  Robot(const Robot&);
  Robot& operator=(const Robot&);
  darwinop::facade::RobotImpl* impl_;
};

}  // namespace webots

#endif
