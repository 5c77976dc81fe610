// What stands behind webots::Robot: the session, the command image, the devices.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
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

class RobotImpl {
 public:
  /// `stop` becomes true when the user asks the controller to end.
  RobotImpl(std::unique_ptr<runtime::RobotLink> link, const ControllerConfig& config, const std::atomic<bool>& stop);
  /// The robot comes to rest meanwhile, which takes seconds; logged if the user requested the end.
  ~RobotImpl();
  RobotImpl(const RobotImpl&) = delete;
  RobotImpl& operator=(const RobotImpl&) = delete;

  /// Waits for the robot to stand ready. Empty: it does; else why not.
  [[nodiscard]] std::string begin();
  void stepBegin(int ms);
  [[nodiscard]] int stepEnd();

  [[nodiscard]] const ControllerConfig& config() const { return config_; }
  [[nodiscard]] const Session& session() const { return session_; }
  /// False: simulated time, which steps as fast as the controller does.
  [[nodiscard]] bool realTime() const { return session_.realTime(); }
  [[nodiscard]] LedCommand& led() { return commands_.led; }
  [[nodiscard]] webots::Keyboard& keyboard() { return keyboard_; }

  /// Null when the robot has no such device.
  [[nodiscard]] webots::Device* find(const std::string& name) const;
  [[nodiscard]] const std::vector<std::unique_ptr<webots::Device>>& devices() const { return devices_; }
  [[nodiscard]] int nextTag() const { return static_cast<int>(devices_.size()) + 1; }

  /// Time since the start, s.
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(session_.time()).count(); }
  /// The board's values, or null when they are older than 3 cycles.
  [[nodiscard]] const BoardSensors* usableBoard() const;
  /// The board's or a joint's values, or null when they are older than 3 cycles; `device` is then named, once.
  [[nodiscard]] const BoardSensors* board(const std::string& device) const;
  [[nodiscard]] const JointSensors* joint(Joint joint, const std::string& device) const;
  /// The same without a word, whatever its age.
  [[nodiscard]] const JointSensors& lastKnown(Joint joint) const { return session_.sensors().joint[index(joint)]; }

  /// The robot's camera; logs later errors itself. Throws std::runtime_error if it has no camera.
  [[nodiscard]] std::unique_ptr<FrameSource> openCamera(int width, int height) {
    return session_.openCamera(width, height, config_.camera);
  }

  /// Where keys come from; throws std::runtime_error when DARWINOP_KEYS is wrong. Another one than the usual: for
  /// tests.
  [[nodiscard]] std::unique_ptr<KeySource> openKeys() const { return open_keys(); }
  std::function<std::unique_ptr<KeySource>()> open_keys;
  /// What sounds are played by; throws std::runtime_error when there is none. Another one: for tests.
  std::function<std::unique_ptr<SoundOutput>()> open_sound;

  /// Takes this P gain instead of the controller's until it is none: then the controller's again, which Motor keeps.
  void lendGain(Joint joint, std::optional<double> kp) { lent_gain_[index(joint)] = kp; }

  /// Who moves joints by itself, a walk or a page; null: nobody. The later one has them, and the other one notices.
  const void* joints_taken_by = nullptr;
  int battery_period = 0;  // as the controller gave it
  std::string custom_data;

 private:
  void addDevices();  // devices.cpp
  void add(webots::Device* device);
  void addLentGain(std::size_t joint);
  void refresh();

  ControllerConfig config_;
  const std::atomic<bool>& stop_;
  bool ends_with_us_;  // the loop: in real time, in this process
  Session session_;
  Commands commands_{};
  std::deque<goals::MotorControl> motors_;  // by joint
  std::array<std::optional<double>, kJoints> lent_gain_{};
  std::array<bool, kJoints> was_lent_{};  // once: from then on every image says the gain
  webots::Keyboard keyboard_{*this};
  std::vector<std::unique_ptr<webots::Device>> devices_;
  std::map<std::string, webots::Device*, std::less<>> by_name_;
};

/// Finds the robot as environment and config.ini say, and waits until it stands ready. Ends the program with a
/// sentence when that fails.
RobotImpl* connectOrExit();

/// The one of this process, or null.
RobotImpl* currentRobot();

/// Where the running program lies; config.ini is beside it.
std::string programDirectory();

/// Makes `robot` the one of this process; for tests.
RobotImpl* adopt(RobotImpl* robot);

/// Deletes `robot` if it is still the one of this process; it then ends its session. Done at the end of the program
/// also.
void release(RobotImpl* robot);

}  // namespace darwinop::webots_api
