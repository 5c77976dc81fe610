// Default controller: start conditions and start.
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "connect/controller_user.hpp"
#include "runtime/controller_run.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/names.hpp"
#include "safety/fault_book.hpp"
#include "safety/start_pose.hpp"
#include "supervisor/child_start.hpp"
#include "supervisor/default_controller.hpp"
#include "supervisor/messages.hpp"

namespace darwinop::supervisor {
namespace {

namespace fs = std::filesystem;

// A robot that a person is setting down passes through the start pose.
constexpr Nanos kSteady{1'000'000'000};

/// A standing robot: some responding leg servo holds its joint.
bool legsHold(const Sensors& seen) {
  constexpr std::uint32_t kBelieved = 5;  // maximum age of a reading, cycles
  for (std::size_t i = index(Joint::kPelvYR); i <= index(Joint::kFootL); ++i) {
    const JointSensors& joint = seen.joint[i];
    if (joint.motion.age <= kBelieved && joint.polled.ever() && joint.torque_enabled) return true;
  }
  return false;
}

}  // namespace

std::string DefaultController::folder() const {
  std::error_code error;
  const fs::path folder = fs::canonical(home_ + "/default", error);
  return error ? std::string{} : folder.string();
}

/// Logs once per `what`; `details` may change without a new message.
bool DefaultController::waitFor(const std::string& what, const std::string& details) {
  in_pose_since_.reset();
  if (state_text_ != what) log("default controller: " + what + details);
  state_text_ = what;
  return false;
}

bool DefaultController::ready(const Sensors& seen, Nanos now) {
  if (folder().empty())
    return waitFor("none installed; select one with: darwinop install --controller DIR --make-default");
  if (const pid_t driver = runtime::FileLock::holder(files_.drive_lock); driver != 0)
    return waitFor("waiting for the end of the controller that drives", " (" + runtime::pidText(driver) + ")");
  if (const Fault fault = safety::latchedFault(seen.safety.active); fault != Fault::kNone)
    return waitFor(messages::kWaitingForUser + std::string{row(fault).meaning} + "; " + messages::kHowToReset);
  if (seen.safety.state == darwinop::State::kOffline) {
    // The safety layer reports a silent board. The previous message stays: with a bad cable the board comes and goes
    // many times a minute.
    in_pose_since_.reset();
    return false;
  }
  const bool held =
      darwinop::drives(seen.safety.state) || (seen.safety.state == darwinop::State::kFoundStiff && legsHold(seen));
  return held || sits(seen, now);
}

/// A robot under torque is moved to the start pose slowly, as at any takeover. A limp robot in another pose may be held
/// by a person or lie on its face.
bool DefaultController::sits(const Sensors& seen, Nanos now) {
  const safety::StartPoseCheck check = safety::checkStartPose(seen, start_pose_);
  if (!check.secure())
    return waitFor(
        messages::kWaitingForPose + std::string{": set the robot upright; details: darwinop runtime --check-pose"},
        "\n" + safety::describe(check));
  if (!in_pose_since_) in_pose_since_ = now;
  return now - *in_pose_since_ >= kSteady;
}

/// Returns false if there is no user to run it as; a retry would fail as well.
bool DefaultController::chooseAccount(process::Start& start) {
  try {
    start.account = connect::defaultControllerAccount(connect::readRobotFile());
    return true;
  } catch (const std::runtime_error& error) {
    become(State::kOver, name_ + messages::kNotStarted + error.what());
    return false;
  }
}

void DefaultController::begin(Nanos now) {
  in_pose_since_.reset();
  latched_at_.reset();
  try {
    const std::string place = folder();
    name_ = fs::path{place}.filename();
    process::Start start = childStart({runtime::controllerProgram(place)}, home_ + "/log/controller.log");
    start.folder = place;
    // No start by the supervisor counts as user action, including the one at boot: a release by a person stays in
    // force.
    start.environment = {"DARWINOP_ROBOT=runtime", std::string{runtime::kUnattended} + "=1"};
    start.expendable = true;
    if (geteuid() == 0 && !chooseAccount(start)) return;
    child_ = std::make_unique<process::ChildProcess>(start);
    become(State::kRunning, name_ + " running (pid " + std::to_string(child_->pid()) + ")");
  } catch (const std::runtime_error& error) {
    log(std::string{"default controller: "} + error.what());
    onEnd({127, false}, now);  // a missing program counts as a failed one
  }
}

}  // namespace darwinop::supervisor
