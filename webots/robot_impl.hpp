// Implementation of webots::Robot: session, command image, devices.
#pragma once

#include <sys/types.h>

#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/goals/motor_control.hpp"
#include "hal/keyboard.hpp"
#include "hal/sound_output.hpp"
#include "webots/Keyboard.hpp"
#include "webots/config_ini.hpp"
#include "webots/session.hpp"

namespace webots {
class Device;
}  // namespace webots

namespace darwinop::webots_api {

struct ToolSession;

class RobotImpl {
 public:
  /// `stop` becomes true when the user requests the controller to end.
  RobotImpl(std::unique_ptr<runtime::RobotLink> link, const ControllerConfig& config, const std::atomic<bool>& stop);
  /// Brings the robot to rest, which may take seconds; logged if the user requested the end.
  ~RobotImpl();
  RobotImpl(const RobotImpl&) = delete;
  RobotImpl& operator=(const RobotImpl&) = delete;

  /// Waits until the robot is ready to be driven. Returns an error message; empty: it is ready.
  [[nodiscard]] std::string begin();
  void stepBegin(int ms);
  [[nodiscard]] int stepEnd();
  /// Sends the motors' goals and waits `ms`, also after the user requested the end: for beforeEnd() of an observer.
  /// False: the loop or safety has ended the session, it is over, or this is a forked child.
  [[nodiscard]] bool carryOn(int ms);
  /// Lets the observers bring the robot where it can kneel, once. Called when a step returns -1, and by release().
  void comeToRest();

  [[nodiscard]] const ControllerConfig& config() const { return config_; }
  [[nodiscard]] const Session& session() const { return session_; }
  /// False in simulated time, where steps run as fast as possible.
  [[nodiscard]] bool realTime() const { return session_.realTime(); }
  [[nodiscard]] LedCommand& led() { return commands_.led; }
  [[nodiscard]] webots::Keyboard& keyboard() { return keyboard_; }

  /// Device by name; null: the robot has no such device.
  [[nodiscard]] webots::Device* find(const std::string& name) const;
  [[nodiscard]] const std::vector<std::unique_ptr<webots::Device>>& devices() const { return devices_; }
  /// What a getter returned for a name; null: nothing yet.
  [[nodiscard]] webots::Device*& made(const char* getter, const std::string& name) { return made_[{getter, name}]; }
  /// Takes over an object that a controller's class made, and returns it; no effect for the robot's own and for null.
  webots::Device* keep(webots::Device* device);
  /// A second object for one of the devices, made by a controller: refreshed as the first one.
  void addSecond(webots::Device* device) { seconds_.push_back(device); }
  void removeSecond(const webots::Device* device);
  [[nodiscard]] int nextTag() const { return static_cast<int>(devices_.size()) + 1; }

  /// Robot time since begin(), s.
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(session_.time()).count(); }
  /// The board's values; null if they are older than 3 cycles.
  [[nodiscard]] const BoardSensors* usableBoard() const;
  /// The board's or a joint's values; null if they are older than 3 cycles, with one warning that names `device`.
  [[nodiscard]] const BoardSensors* board(const std::string& device) const;
  [[nodiscard]] const JointSensors* joint(Joint joint, const std::string& device) const;
  /// Values of any age, without a warning.
  [[nodiscard]] const JointSensors& lastKnown(Joint joint) const { return session_.sensors().joint[index(joint)]; }

  /// The robot's camera; logs later errors itself. Throws std::runtime_error if it has no camera.
  [[nodiscard]] std::unique_ptr<FrameSource> openCamera(int width, int height) {
    return session_.openCamera(width, height, config_.camera);
  }

  /// Opens the keyboard. Throws std::runtime_error if DARWINOP_KEYS is invalid. Tests replace `open_keys`.
  [[nodiscard]] std::unique_ptr<KeySource> openKeys() const { return open_keys(); }
  std::function<std::unique_ptr<KeySource>()> open_keys;
  /// Opens the sound output. Throws std::runtime_error if there is none. Tests replace it.
  std::function<std::unique_ptr<SoundOutput>()> open_sound;

  /// Overrides the controller's P gain; empty: ends the override. Motor keeps the controller's value meanwhile.
  void lendGain(Joint joint, std::optional<double> kp) { lent_gain_[index(joint)] = kp; }
  /// Overrides the controller's speed limit and acceleration with the maximum speed. Motor keeps its values meanwhile.
  void lendFullSpeed(Joint joint, bool lent) { full_speed_[index(joint)] = lent; }

  /// Owner of the joints: the manager that walks or plays a motion page; null: none. A later one takes over; the
  /// earlier one detects this and stops.
  const void* joints_taken_by = nullptr;
  int battery_period = 0;  // ms, as set by the controller
  std::string custom_data;
  bool is_tool = false;  // of a ToolRobot: a setting that a controller is warned of is meant

 private:
  void addDevices();  // devices.cpp
  void removeDevicesOfBoard();
  void add(webots::Device* device);
  void addLentGain(std::size_t joint);
  void addLentSpeed(std::size_t joint);
  void takeMotors(int ms);
  void refresh();
  void refreshDevices();

  ControllerConfig config_;
  const std::atomic<bool>& stop_;
  bool ends_with_us_;  // the loop ends with this process, in real time
  pid_t process_;      // a child that it forks must not move the robot
  bool resting_ = false, over_ = false;
  Session session_;
  Commands commands_{};
  std::deque<goals::MotorControl> motors_;  // by joint
  std::array<std::optional<double>, kJoints> lent_gain_{};
  std::array<bool, kJoints> was_lent_{};  // overridden before: from then on every image sets the gain
  std::array<bool, kJoints> full_speed_{}, had_full_speed_{};  // the same for the speed limit
  webots::Keyboard keyboard_{*this};
  std::vector<std::unique_ptr<webots::Device>> devices_;
  std::vector<webots::Device*> seconds_;
  std::vector<std::unique_ptr<webots::Device>> kept_;                    // those of seconds_ that the robot deletes
  std::map<std::pair<std::string, std::string>, webots::Device*> made_;  // by getter and name
  std::map<std::string, webots::Device*, std::less<>> by_name_;
};

/// Connects to the robot configured by environment and config.ini, and waits until it is ready. On failure prints a
/// message and ends the program.
RobotImpl* connectOrExit();

/// The same, but throws std::exception with the reason instead of ending the program. `tool`: of a
/// ToolRobot; null: a controller.
RobotImpl* connectOrThrow(const ToolSession* tool = nullptr);

/// The robot of this process; null: none.
RobotImpl* currentRobot();

/// Folder of the running program and of config.ini.
std::string programDirectory();

/// Sets it, before the robot is made: for a program that an interpreter runs.
void setProgramDirectory(const std::string& directory);

/// Sets the robot of this process; for tests.
RobotImpl* adopt(RobotImpl* robot);

/// Deletes `robot`, which ends its session, if it is still the robot of this process. Also called at program exit.
void release(RobotImpl* robot);

}  // namespace darwinop::webots_api
