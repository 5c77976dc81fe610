// Implementation of webots::Robot.
#include "webots/robot_impl.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "connect/keys.hpp"
#include "connect/sound_program.hpp"
#include "webots/Device.hpp"
#include "webots/messages.hpp"
#include "webots/motion_playback.hpp"
#include "webots/notices.hpp"
#include "webots/step_observer.hpp"

namespace darwinop::webots_api {

namespace {
std::string_view endNotice(Reaction at_end) {
  if (at_end == Reaction::kHold) return messages::kEndsHolding;
  return at_end == Reaction::kKneel ? messages::kEndsKneeling : messages::kEndsLimp;
}

/// DARWINOP_KEYS selects window, terminal or none; unset: automatic.
std::unique_ptr<KeySource> openTheUsualKeys(const std::atomic<bool>& stop) {
  const auto environment = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string{value != nullptr ? value : ""};
  };
  return connect::openKeys({.from = environment("DARWINOP_KEYS"),
                            .display = environment("DISPLAY"),
                            .log = [](const std::string& what) { logLine("Keyboard: " + what); }},
                           stop);
}

void warnMissing(const std::string& device) {
  warnOnce(device + " has not answered for more than 3 cycles: its values are NaN (not a number) until it does");
}
}  // namespace

RobotImpl::RobotImpl(std::unique_ptr<runtime::RobotLink> link, const ControllerConfig& config,
                     const std::atomic<bool>& stop)
    : open_keys{[&stop] { return openTheUsualKeys(stop); }},
      open_sound{connect::openSound},
      config_{config},
      stop_{stop},
      ends_with_us_{link->bringsToRest()},
      process_{getpid()},
      session_{std::move(link), stop} {
  commands_.start_where_it_is = config.safety.start == safety::StartMove::kHold;
  addDevices();
}

RobotImpl::~RobotImpl() {
  if (stop_ && ends_with_us_) logLine(endNotice(session_.sensors().safety.at_end));
}

void RobotImpl::add(webots::Device* device) {
  devices_.emplace_back(device);
  by_name_.emplace(device->getName(), device);
}

std::string RobotImpl::begin() {
  std::string sentence = session_.begin(commands_);
  if (session_.sensors().board.absent) removeDevicesOfBoard();
  refresh();
  return sentence;
}

void RobotImpl::stepBegin(int ms) {
  advanceMotions(*this);
  notifyBeforeStep(ms);
  takeMotors(ms);
  session_.publish(commands_, ms);
}

void RobotImpl::takeMotors(int ms) {
  const Sensors& seen = session_.sensors();
  const auto usual_gain = static_cast<double>(seen.safety.default_p_gain);
  for (std::size_t i = 0; i < kJoints; ++i) {
    commands_.joint[i] = motors_[i].command(seen.joint[i], usual_gain, std::max(ms, 0) / 1000.0);
    addLentGain(i);
    addLentSpeed(i);
  }
}

/// A gain that is not in the image stays unchanged, so the end of an override must set the previous gain explicitly.
void RobotImpl::addLentGain(std::size_t joint) {
  JointCommand& command = commands_.joint[joint];
  if (lent_gain_[joint]) {
    was_lent_[joint] = true;
    command.setPGain(*lent_gain_[joint]);
  } else if (was_lent_[joint] && !command.has(JointCommand::kPGain)) {
    const double usual = static_cast<double>(session_.sensors().safety.default_p_gain);
    command.setPGain(std::isnan(usual) ? config_.safety.default_p_gain : usual);  // NaN: no cycle yet
  }
}

void RobotImpl::addLentSpeed(std::size_t joint) {
  JointCommand& command = commands_.joint[joint];
  if (full_speed_[joint]) {
    had_full_speed_[joint] = true;
    motors_[joint].restartRamp();
    command.setSpeedLimit(RadPerSec{kMaxVelocity});
  } else if (had_full_speed_[joint] && !command.has(JointCommand::kSpeedLimit)) {
    const double usual = static_cast<double>(session_.sensors().safety.default_speed);
    command.setSpeedLimit(RadPerSec{std::isnan(usual) ? config_.safety.default_speed : usual});  // NaN: no cycle yet
  }
}

int RobotImpl::stepEnd() {
  const int result = session_.wait();
  refresh();
  if (result == -1) comeToRest();
  return result;
}

bool RobotImpl::carryOn(int ms) {
  if (over_ || getpid() != process_) return false;
  takeMotors(ms);
  if (!session_.carryOn(commands_, std::chrono::milliseconds{ms})) return false;
  refreshDevices();
  return true;
}

void RobotImpl::comeToRest() {
  if (resting_) return;
  resting_ = true;
  notifyBeforeEnd();
  over_ = true;
}

/// Controllers may keep the pointers of getValues() and getImage(); their data must be updated in every step.
void RobotImpl::refresh() {
  refreshDevices();
  keyboard_.refresh(seconds());
}

void RobotImpl::refreshDevices() {
  for (const auto& device : devices_) device->refresh();
  for (webots::Device* const device : seconds_) device->refresh();
}

webots::Device* RobotImpl::keep(webots::Device* device) {
  const bool is_second = std::ranges::find(seconds_, device) != seconds_.end();
  const bool is_kept = std::ranges::any_of(kept_, [device](const auto& kept) { return kept.get() == device; });
  if (is_second && !is_kept) kept_.emplace_back(device);
  return device;
}

/// The controller deletes it while the robot exists.
void RobotImpl::removeSecond(const webots::Device* device) {
  std::erase(seconds_, device);
  std::erase_if(made_, [device](const auto& entry) { return entry.second == device; });
  const auto kept = std::ranges::find_if(kept_, [device](const auto& owned) { return owned.get() == device; });
  if (kept == kept_.end()) return;
  static_cast<void>(kept->release());
  kept_.erase(kept);
}

webots::Device* RobotImpl::find(const std::string& name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : found->second;
}

const BoardSensors* RobotImpl::usableBoard() const {
  const BoardSensors& board = session_.sensors().board;
  return board.motion.stale() ? nullptr : &board;
}

const BoardSensors* RobotImpl::board(const std::string& device) const {
  const BoardSensors* const board = usableBoard();
  if (board == nullptr) warnMissing(device);
  return board;
}

const JointSensors* RobotImpl::joint(Joint joint, const std::string& device) const {
  if (!lastKnown(joint).motion.stale()) return &lastKnown(joint);
  warnMissing(device);
  return nullptr;
}

}  // namespace darwinop::webots_api
