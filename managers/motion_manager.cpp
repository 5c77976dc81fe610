// Implements the upstream motion manager API with the page player. Throws no exceptions to the controller.
#include <algorithm>
#include <memory>
#include <string>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

#include "DARwInOPDirectoryManager.hpp"
#include "DARwInOPMotionManager.hpp"
#include "managers/body_player/following.hpp"
#include "managers/body_player/page_player.hpp"
#include "managers/messages.hpp"
#include "managers/motion_source.hpp"
#include "managers/present_pose.hpp"
#include "managers/step_clock.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"
#include "webots/step_observer.hpp"

namespace managers {

using darwinop::Joint;
using darwinop::kJoints;
using darwinop::body_player::PagePlayer;
using darwinop::webots_api::warnOnce;

struct DARwInOPMotionManager::Stage final : darwinop::webots_api::StepObserver {
  webots::Robot* robot = nullptr;
  MotionPages pages;  // null: nothing can be played
  std::unique_ptr<PagePlayer> player;
  bool gains_are_lent = false;  // the joints have the page's P gains
  bool waited_for = false;      // inside playPage(), to reject calls from an overridden Robot::step()
  bool stepped = false;         // the controller calls step(); otherwise Robot::step() plays
  StepClock clock;              // of Robot::step()
  darwinop::body_player::Following following;

  Stage(webots::Robot* owner, MotionPages file) : robot{owner}, pages{std::move(file)} {
    if (pages) player = std::make_unique<PagePlayer>(*pages);
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage() override { end(); }

  [[nodiscard]] bool isPlaying() const { return player && player->isPlaying(); }
  bool start(int page);
  bool advance(double ms);
  bool advanceOnRobotsTime(int declared_ms);
  void end();

  /// Code of the robot of 2013 calls no step() of the manager: there a thread played the page.
  void beforeStep(int ms) override {
    if (isPlaying() && !waited_for && !stepped) advanceOnRobotsTime(ms);
  }
  void beforeEnd() override {}

 private:
  [[nodiscard]] bool waitsForRobot(const darwinop::webots_api::RobotImpl& inside, double ms);
  void setGoals(darwinop::webots_api::RobotImpl& inside);
};

/// False if the page cannot be played; a warning has been logged.
bool DARwInOPMotionManager::Stage::start(int page) {
  const std::string name = "MotionManager: page " + std::to_string(page);
  darwinop::webots_api::RobotImpl* const inside = darwinop::webots_api::currentRobot();
  if (!pages || !inside) {
    warnOnce(name + " is skipped: no " + (pages ? "robot" : "motion file"));
    return false;
  }
  if (player->isPlaying()) {
    warnOnce(name + " is refused: page " + std::to_string(player->page()) + " is still being played");
    return false;
  }
  if (player->start(page, presentPose(*robot, *inside))) {
    inside->joints_taken_by = this;
    clock.restart();
    following = {};
    return true;
  }
  warnOnce(name + (page < 1 || page > 255 ? " does not exist: pages are 1 to 255" : " is empty: nothing is played"));
  return false;
}

/// Plays for a step of `declared_ms`, or longer if the controller's loop is slower than that.
bool DARwInOPMotionManager::Stage::advanceOnRobotsTime(int declared_ms) {
  const darwinop::webots_api::RobotImpl* const inside = darwinop::webots_api::currentRobot();
  const double ms = std::max(declared_ms, 0);
  return advance(inside ? clock.advance(ms, inside->session().robotMs(), inside->session().periodMs()) : ms);
}

/// Plays for `ms`. False if the page has ended and the joints have their final goals.
bool DARwInOPMotionManager::Stage::advance(double ms) {
  darwinop::webots_api::RobotImpl* const inside = darwinop::webots_api::currentRobot();
  if (inside && waitsForRobot(*inside, ms)) return player->isPlaying();
  const bool moved = player->advance(std::clamp(ms, 0.0, 3'600'000.0));  // an hour is longer than any page
  if (!inside || inside->joints_taken_by != this)
    player->brake();  // the robot is gone, or another manager has taken the joints
  else if (moved)
    setGoals(*inside);
  if (!player->isPlaying()) end();
  return moved || player->isPlaying();
}

/// True while the robot does not follow. A page that waited for too long is over.
bool DARwInOPMotionManager::Stage::waitsForRobot(const darwinop::webots_api::RobotImpl& inside, double ms) {
  following.update(inside.session().sensors().safety.state, ms);
  if (following.isLost()) {
    warnOnce("MotionManager: page " + std::to_string(player->page()) + messages::kNotFollowed);
    end();
  }
  return !following.isGiven();
}

void DARwInOPMotionManager::Stage::setGoals(darwinop::webots_api::RobotImpl& inside) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    robot->getMotor(std::string{row(joint).name})->setPosition(player->goal(joint));
    inside.lendGain(joint, player->pGain(joint));
  }
  gains_are_lent = true;
}

/// Ends the page and restores the controller's gains.
void DARwInOPMotionManager::Stage::end() {
  if (player) player->brake();
  darwinop::webots_api::RobotImpl* const inside = darwinop::webots_api::currentRobot();
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
  if (!robot) warnOnce(std::string{"MotionManager: "} + messages::kRobotIsNull + "; no page will be played");
  stage_ = new Stage{robot, robot ? readMotionPages(custom_motion_file, data_directory) : nullptr};
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
  const struct Waited {  // ends the page also if an overridden Robot::step() throws
    Stage& stage;
    ~Waited() {
      stage.waited_for = false;
      stage.end();
    }
  } waited{*stage_};
  while (stage_->advanceOnRobotsTime(step_ms))
    if (stage_->robot->step(step_ms) == -1) return;
}

void DARwInOPMotionManager::step(int ms) {
  stage_->stepped = true;
  if (stage_->isPlaying() && !stage_->waited_for) stage_->advance(ms);
}

bool DARwInOPMotionManager::isMotionPlaying() {
  return stage_->isPlaying();
}

}  // namespace managers
