// The upstream motion manager on top of the player: 8 ms ticks into steps, ticks into goals, and no exception outwards.
#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <string>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

#include "DARwInOPDirectoryManager.hpp"
#include "DARwInOPMotionManager.hpp"
#include "core/conversions.hpp"
#include "managers/motion/player.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace managers {

using darwinop::Joint;
using darwinop::kJoints;
using darwinop::facade::warnOnce;
namespace motion = darwinop::motion;

namespace {

constexpr const char* kFileName = "motion_4096.bin";

// A servo with the usual P gain, 4, pulls with all it has from 256 ticks (22.5 degrees) on. A goal that is farther from
// where the joint is pulls no harder, so that one this far away is no jump, and a page need not begin any farther.
constexpr int kFullPullTicks = 256;

std::shared_ptr<const motion::PageFile> read(const std::string& path) {
  try {
    return std::make_shared<motion::PageFile>(motion::readPageFile(path));
  } catch (const std::exception& why) {
    warnOnce(std::string{"MotionManager: "} + why.what() + "; no page will be played");
    return nullptr;
  }
}

/// The goal that the joint has, as the robot holds it after safety and not as the controller wishes it. For a limp
/// joint where it is, and what was wished last when nobody knows.
int presentTicks(const darwinop::JointSensors& joint, const webots::Motor& motor) {
  if (!joint.commanded.known()) {
    const double wished = motor.getTargetPosition();
    if (joint.position.known()) return ticksFromRad(joint.position);
    return std::isfinite(wished) ? ticksFromRad(darwinop::Rad{wished}) : darwinop::kTickCentre;
  }
  const int held = ticksFromRad(joint.commanded);
  if (!joint.position.known()) return held;
  const int seen = ticksFromRad(joint.position);
  return std::clamp(held, seen - kFullPullTicks, seen + kFullPullTicks);
}

}  // namespace

struct DARwInOPMotionManager::Stage {
  webots::Robot* robot = nullptr;
  std::shared_ptr<const motion::PageFile> pages;  // none: nothing is ever played
  std::unique_ptr<motion::Player> player;
  int left_ms = 0;              // of the last step(), less than a tick
  bool gains_are_lent = false;  // the joints have the page's
  bool waited_for = false;      // inside playPage(): a Robot::step() of the user may call us

  Stage(webots::Robot* whose, std::shared_ptr<const motion::PageFile> file) : robot{whose}, pages{std::move(file)} {
    if (pages) player = std::make_unique<motion::Player>(*pages);
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage() { end(); }

  [[nodiscard]] bool isPlaying() const { return player && player->isPlaying(); }
  bool start(int page);
  bool advance(int ms);
  void end();

 private:
  void setGoals();
};

/// False: it cannot be played, which was said.
bool DARwInOPMotionManager::Stage::start(int page) {
  const std::string name = "MotionManager: page " + std::to_string(page);
  darwinop::facade::RobotImpl* const inside = darwinop::facade::currentRobot();
  if (!pages || !inside) {
    warnOnce(name + " is skipped: there is no " + (pages ? "robot" : "motion file"));
    return false;
  }
  if (player->isPlaying()) {
    warnOnce(name + " is refused: page " + std::to_string(player->page()) + " is still being played");
    return false;
  }
  motion::Pose present;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    const webots::Motor* const motor = robot->getMotor(std::string{row(joint).name});
    present[i] = presentTicks(inside->lastKnown(joint), *motor);
  }
  left_ms = 0;
  if (player->start(page, present)) {
    inside->joints_taken_by = this;
    return true;
  }
  warnOnce(name + (page < 1 || page > 255 ? " does not exist: pages are 1 to 255" : " is empty: nothing is played"));
  return false;
}

/// Plays this much longer. False: the page has ended, and the joints have their goals already.
bool DARwInOPMotionManager::Stage::advance(int ms) {
  bool moved = false;
  // No step is longer than an hour; a greater number would play no more than the longest of pages anyway.
  for (left_ms += std::clamp(ms, 0, 3'600'000); left_ms >= motion::kTickMs; left_ms -= motion::kTickMs) {
    if (!player->tick()) break;
    moved = true;
  }
  if (const auto* const inside = darwinop::facade::currentRobot(); inside && inside->joints_taken_by != this)
    player->brake();  // somebody else moves them by now
  else if (moved)
    setGoals();
  if (!player->isPlaying()) end();
  return moved || player->isPlaying();
}

void DARwInOPMotionManager::Stage::setGoals() {
  darwinop::facade::RobotImpl* const inside = darwinop::facade::currentRobot();
  if (!inside) return player->brake();
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    robot->getMotor(std::string{row(joint).name})->setPosition(darwinop::radFromTicks(player->pose()[i]).value);
    inside->lendGain(joint, player->pGainRegister(joint) / 8.0);
  }
  gains_are_lent = true;
}

/// Ends here, and the gains are the controller's again.
void DARwInOPMotionManager::Stage::end() {
  if (player) player->brake();
  left_ms = 0;
  darwinop::facade::RobotImpl* const inside = darwinop::facade::currentRobot();
  if (inside && inside->joints_taken_by == this) {
    inside->joints_taken_by = nullptr;
    if (gains_are_lent)
      for (std::size_t i = 0; i < kJoints; ++i) inside->lendGain(static_cast<Joint>(i), {});
  }
  gains_are_lent = false;
}

DARwInOPMotionManager::DARwInOPMotionManager(webots::Robot* robot, const std::string& custom_motion_file)
    : DARwInOPMotionManager{robot, custom_motion_file, DARwInOPDirectoryManager::getDataDirectory()} {}

DARwInOPMotionManager::DARwInOPMotionManager(webots::Robot* robot, const std::string& custom_motion_file,
                                             const std::string& data_directory)
    : stage_{nullptr} {
  if (!robot) warnOnce("MotionManager: it was given no robot; no page will be played");
  const std::string path = custom_motion_file.empty() ? data_directory + kFileName : custom_motion_file;
  stage_ = new Stage{robot, robot ? read(path) : nullptr};
}

DARwInOPMotionManager::DARwInOPMotionManager(const DARwInOPMotionManager& other)
    : stage_{new Stage{other.stage_->robot, other.stage_->pages}} {}

DARwInOPMotionManager& DARwInOPMotionManager::operator=(const DARwInOPMotionManager& other) {
  if (this == &other) return *this;
  Stage* const copy = new Stage{other.stage_->robot, other.stage_->pages};
  delete stage_;
  stage_ = copy;
  return *this;
}

DARwInOPMotionManager::~DARwInOPMotionManager() {
  delete stage_;
}

bool DARwInOPMotionManager::isCorrectlyInitialized() {
  return stage_->pages != nullptr;
}

void DARwInOPMotionManager::playPage(int id, bool sync) {
  if (!stage_->start(id) || !sync) return;
  const int step_ms = std::max(1, static_cast<int>(stage_->robot->getBasicTimeStep()));
  stage_->waited_for = true;
  const struct Waited {  // also when the user's Robot::step() throws
    Stage& stage;
    ~Waited() {
      stage.waited_for = false;
      stage.end();
    }
  } waited{*stage_};
  while (stage_->advance(step_ms))
    if (stage_->robot->step(step_ms) == -1) return;
}

void DARwInOPMotionManager::step(int ms) {
  if (stage_->isPlaying() && !stage_->waited_for) stage_->advance(ms);
}

bool DARwInOPMotionManager::isMotionPlaying() {
  return stage_->isPlaying();
}

}  // namespace managers
