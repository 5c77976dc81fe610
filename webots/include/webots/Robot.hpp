// The robot that a controller drives, and the way to its devices.
#ifndef ROBOT_HPP
#define ROBOT_HPP

// Not needed here: controllers written since 2013 rely on these includes.
#include <pthread.h>
#include <sys/time.h>

#include <iostream>
#include <map>
#include <string>
#include <vector>
#include <webots/absent_devices.hpp>

namespace darwinop {
namespace webots_api {
class RobotImpl;
}
}  // namespace darwinop

namespace webots {

class Accelerometer;
class Camera;
class Device;
class Gyro;
class Joystick;
class Keyboard;
class LED;
class Motor;
class Mouse;
class PositionSensor;
class Servo;
class Speaker;
class TouchSensor;
#define DARWINOP_CLASS(CLASS) class CLASS;
DARWINOP_ABSENT_DEVICES(DARWINOP_CLASS)
#undef DARWINOP_CLASS

/// Create one object, or one of a derived class; a second one in the same process ends the program.
///
///     webots::Robot robot;                            // blocks until the robot is in its start pose
///     webots::Motor* neck = robot.getMotor("Neck");
///     while (robot.step(16) != -1) {                  // 16 ms; -1: end the program
///       neck->setPosition(0.3 * sin(robot.getTime()));  // rad; sent by the next step
///     }
///
/// Data flow: setters of devices change one command image. step() sends it, waits, and takes one consistent sensor
/// image, which all getters read until the next step. So nothing moves and no LED changes between steps. A value that
/// was not received for more than 3 cycles (48 ms at 16 ms) is NaN, never 0 and never an old value; one line on stderr
/// names the device.
///
/// Errors: calls do not throw. A call with an unusable argument or without effect logs one warning on stderr.
///
/// Simulated robots: `--robot virtual` and `twin` run in this process in simulated time, `/dev/...` and a pty in real
/// time, `tcp://HOST` over a network; the same program runs on each.
///
/// Threads: not thread-safe. Call all methods of the robot, its devices and the managers from the thread that made it.
class Robot {
 public:
  /// Where the controller runs; see getMode().
  enum Mode { MODE_SIMULATION = 0, MODE_CROSS_COMPILATION = 1, MODE_REMOTE_CONTROL = 2 };
  /// Of the simulator's window; never reported here.
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
  /// Key codes under the names of 2013; the same values as in Keyboard.
  enum {
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

  /// Connects to the robot and blocks until it is ready for commands:
  ///  - installs the signal handlers (docs/threads.md#signals);
  ///  - changes to the directory of the program, unless DARWINOP_KEEP_CWD=1, and reads config.ini there
  ///  (docs/config.md);
  ///  - connects to the robot that DARWINOP_ROBOT names (`darwinop run --robot` sets it);
  ///  - moves the joints slowly to the start pose, or with `[Safety] start = hold` leaves them where they are.
  /// On failure it prints the reason on stderr and ends the program with exit status 1.
  /// Simulator: returns at once. 2013: a fixed move of 2 s.
  Robot();

  /// Ends the driving session. The robot then does what `[Safety] on_exit` says: kneel (default), hold or limp.
  /// exit() and an uncaught exception of the thread that made the Robot end the session in the same way; a process that
  /// this one forked does not. 2013: servos kept their last goals for ever.
  virtual ~Robot();

  /// Sends the commands, waits, and takes a new sensor image. `duration` in ms; use getBasicTimeStep() or a multiple.
  /// Waits until `duration` after the previous step on an absolute time line in whole cycles of the loop; the remainder
  /// is carried over, so step(20) lasts 20 ms on average at 16 ms a cycle. 0 or less: sends and does not wait.
  /// The loop continues during long steps; safety does not treat them as a stalled controller.
  ///
  /// Returns 0: in time. Positive: late by this many ms, and the next step counts from now. -1: end the program; every
  /// later call returns -1 at once. Reasons, printed once: Ctrl-C, Ctrl-\, SIGTERM, SIGHUP, SIGXCPU, SIGPWR, a fault
  /// that ends controllers (docs/faults.md), or the loop has ended. After a signal during a walk of the gait manager
  /// the first -1 comes when its steps are finished, after 2.9 s at most. A second Ctrl-C, Ctrl-\ or SIGTERM 0.3 s
  /// after the first kills the program; where it hosts the loop, the joints then stay under torque.
  ///
  /// Real time on a robot and with a port; with `--robot virtual` and `twin` the step runs the cycles itself, as fast
  /// as the machine allows. Simulator: does not return a delay when synchronized.
  virtual int step(int duration);

  /// First half of step(): sends the commands and does not wait. `duration` in ms, as in step(). Returns 0.
  /// The controller may compute until it calls stepEnd(). 2013: not available.
  virtual int stepBegin(int duration);

  /// Second half of step(): waits and takes the sensor image. Returns what step() returns: 0, a delay in ms, or -1.
  virtual int stepEnd();

  /// "darwin-op", on every robot.
  std::string getName() const;
  /// "DARwIn-OP", on every robot.
  std::string getModel() const;
  /// Time in s, resolution 1 ms, since the robot was ready. After n steps of 16 ms in time it is n * 0.016.
  /// In real time it advances between steps; the simulator's does not, nor does it in lockstep. 2013: it started before
  /// the move to the start pose.
  double getTime() const;
  /// MODE_CROSS_COMPILATION (1), also with the twin and over TCP. Simulator: MODE_SIMULATION (0).
  Mode getMode() const { return MODE_CROSS_COMPILATION; }
  /// Node::ROBOT, a number to compare by name.
  int getType() const;
  /// Basic time step in ms: `time_step` of config.ini, 1 to 10000, default 16. The loop's own period is independent of
  /// it. Simulator: of the world file. 2013: undefined without config.ini.
  double getBasicTimeStep() const;

  /// "Accelerometer". NULL and one warning for any other name; the same holds for the getters below. Devices belong to
  /// the robot and live as long as it does. 2013: NULL without a warning.
  Accelerometer* getAccelerometer(const std::string& name) const;
  /// "Camera". It opens its hardware in Camera::enable(), not here.
  Camera* getCamera(const std::string& name) const;
  /// "Gyro".
  Gyro* getGyro(const std::string& name) const;
  /// Keys of a window or of the terminal; never NULL.
  Keyboard* getKeyboard() const;
  /// "EyeLed", "HeadLed", "BackLedRed", "BackLedGreen", "BackLedBlue".
  LED* getLED(const std::string& name) const;
  /// A joint: "ShoulderR" ... "Head" (docs/registers.md). The same object as getServo() returns.
  Motor* getMotor(const std::string& name) const;
  /// The encoder of a joint: its name and an S, "ShoulderRS" ... "HeadS".
  PositionSensor* getPositionSensor(const std::string& name) const;
  /// A joint under the class name of 2013. The same object as getMotor() returns.
  Servo* getServo(const std::string& name) const;
  /// "Speaker".
  Speaker* getSpeaker(const std::string& name) const;
  /// "ButtonMode" and "ButtonStart". Neither the simulator's model nor 2013 has them.
  TouchSensor* getTouchSensor(const std::string& name) const;
  /// Absent here: never NULL, but not connected, with one warning.
  Joystick* getJoystick() const;
  /// Absent here: never NULL, but outside of the window, with one warning.
  Mouse* getMouse() const;

  // Devices of the simulator that this robot does not have: getAltimeter(name), getBrake(name) and so on for each row
  // of absent_devices.hpp. Absent here: NULL, and one warning for each name, as in simulation on a robot without the
  // device; or what the maker of the same device returns.
#define DARWINOP_GETTER(CLASS) CLASS* get##CLASS(const std::string& name) const;
  DARWINOP_ABSENT_DEVICES(DARWINOP_GETTER)
#undef DARWINOP_GETTER

  /// Any device by name, except keyboard, joystick and mouse.
  Device* getDevice(const std::string& name) const;
  /// Number of devices that getDeviceByIndex() returns; the keyboard is not one of them.
  int getNumberOfDevices() const;
  /// `index` from 0 to getNumberOfDevices() - 1; NULL outside of this range.
  Device* getDeviceByIndex(int index) const;

  /// Stores `sampling_period` in ms; the voltage is read anyway, in every cycle. 2013: no battery sensor.
  virtual void batterySensorEnable(int sampling_period);
  /// Sets the sampling period to 0; the voltage is still read.
  virtual void batterySensorDisable();
  /// ms as set last; 0: disabled.
  int batterySensorGetSamplingPeriod() const;
  /// Supply voltage in V, about 10 (empty) to 12.6 (full) with a battery of 3 LiPo cells. NaN: the board has not
  /// answered for more than 3 cycles. Simulator: energy in J.
  double batterySensorGetValue() const;

  /// Same as Keyboard::enable(); `sampling_period` in ms.
  virtual void keyboardEnable(int sampling_period);
  /// Same as Keyboard::disable().
  virtual void keyboardDisable();
  /// As Keyboard::getKey(), but 0 when there is no more key.
  int keyboardGetKey() const;

  /// The robot of this process; NULL before its constructor has returned and after its destructor.
  static Robot* getInstance();
  /// Directory of the program, absolute. Simulator: directory of the project.
  std::string getProjectPath() const;
  /// The text that setCustomData() stored; empty at first. Kept in the program only. Simulator: stored in the world.
  std::string getCustomData() const;
  /// Stores a text of any length for getCustomData().
  void setCustomData(const std::string& data);
  /// Same as getCustomData(), under an earlier name.
  std::string getData() const;
  /// Same as setCustomData(), under an earlier name.
  void setData(const std::string& data);

  /// Name of the program, without its folder. 2013: of the controller.
  std::string getControllerName() const;
  /// Arguments of the program, separated by blanks; empty: none.
  std::string getControllerArguments() const;

  // Of the simulator only: without effect here; calls that would do something there log one warning.

  /// Absent here: empty; a robot has no world file.
  std::string getWorldPath() const;
  /// Absent here: empty in this version.
  std::string getUrdf(std::string prefix = "") const;
  /// Absent here: false; a robot has no scene tree (Supervisor.hpp).
  bool getSupervisor() const {
    return false;
  }
  /// Absent here: false; a robot does not wait for its controller.
  bool getSynchronization() const {
    return false;
  }
  /// Absent here: no effect; DARWINOP_ROBOT selects the robot when the program starts.
  virtual void setMode(Mode mode, const char* arg);
  /// Absent here: EVENT_NO_EVENT at once; `timeout` in ms is ignored.
  UserInputEvent waitForUserInputEvent(UserInputEvent event_type, int timeout);
  /// Absent here: no effect; `size` in bytes. `darwinop window` has its own connection.
  virtual void wwiSend(const char* data, int size);
  /// Absent here: no effect, as wwiSend().
  virtual void wwiSendText(const std::string& text);
  /// Absent here: NULL, and `*size` is set to 0 bytes.
  const char* wwiReceive(int* size);
  /// Absent here: empty.
  virtual std::string wwiReceiveText();
  /// Absent here: NULL.
  virtual void* windowCustomFunction(void* arg);

 protected:
  // Makers of devices, to be overridden by a class that has device classes of its own:
  //
  //     virtual LED* createLED(const std::string& name) const { return new BlinkingLed(name); }  // class of LED
  //
  // The getter of the same name calls it once per name, at each call while it returns NULL, and the robot deletes what
  // it returned.

  /// As getAccelerometer(); a new one at each call, where overridden.
  virtual Accelerometer* createAccelerometer(const std::string& name) const;
  /// As getCamera(); a new one at each call, where overridden.
  virtual Camera* createCamera(const std::string& name) const;
  /// As getGyro(); a new one at each call, where overridden.
  virtual Gyro* createGyro(const std::string& name) const;
  /// As getLED(); a new one at each call, where overridden.
  virtual LED* createLED(const std::string& name) const;
  /// As getMotor(); a new one at each call, where overridden.
  virtual Motor* createMotor(const std::string& name) const;
  /// As getPositionSensor(); a new one at each call, where overridden.
  virtual PositionSensor* createPositionSensor(const std::string& name) const;
  /// As getServo(); a new one at each call, where overridden.
  virtual Servo* createServo(const std::string& name) const;
  /// As getSpeaker(); a new one at each call, where overridden.
  virtual Speaker* createSpeaker(const std::string& name) const;
  /// As getTouchSensor(); a new one at each call, where overridden.
  virtual TouchSensor* createTouchSensor(const std::string& name) const;
#define DARWINOP_MAKER(CLASS) virtual CLASS* create##CLASS(const std::string& name) const;
  DARWINOP_ABSENT_DEVICES(DARWINOP_MAKER)
#undef DARWINOP_MAKER

  /// For tests: a robot that was made elsewhere; this object then owns it.
  explicit Robot(darwinop::webots_api::RobotImpl* impl);

 private:
  Robot(const Robot&);
  Robot& operator=(const Robot&);
  darwinop::webots_api::RobotImpl* impl_;
};

}  // namespace webots

#endif
