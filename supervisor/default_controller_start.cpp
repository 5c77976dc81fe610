// When the default controller may begin, and how it does.
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
#include "supervisor/default_controller.hpp"

namespace darwinop::supervisor {
namespace {

namespace fs = std::filesystem;

// A robot that somebody is just setting down passes through the start pose.
constexpr Nanos kSteady{1'000'000'000};

/// A robot that stands: some leg servo that answers holds its joint.
bool legsHold(const Sensors& seen) {
  constexpr std::uint32_t kBelieved = 5;  // cycles
  for (std::size_t i = index(Joint::kPelvYR); i <= index(Joint::kFootL); ++i) {
    const JointSensors& joint = seen.joint[i];
    if (joint.motion.age <= kBelieved && joint.health.ever() && joint.torque_enabled) return true;
  }
  return false;
}

}  // namespace

std::string DefaultController::folder() const {
  std::error_code error;
  const fs::path folder = fs::canonical(home_ + "/default", error);
  return error ? std::string{} : folder.string();
}

/// Says it once; `details` may change while it waits and are not said again.
bool DefaultController::waitFor(const std::string& what, const std::string& details) {
  in_pose_since_.reset();
  if (told_ != what) say("default controller: " + what + details);
  told_ = what;
  return false;
}

bool DefaultController::ready(const Sensors& seen, Nanos now) {
  if (folder().empty())
    return waitFor("there is none; choose one with: darwinop install --controller DIR --make-default");
  if (const pid_t driver = runtime::FileLock::holder(files_.drive_lock); driver != 0)
    return waitFor("waits until the controller that drives now has ended", " (pid " + std::to_string(driver) + ")");
  if (const Fault fault = safety::latchedFault(seen.safety.active); fault != Fault::kNone)
    return waitFor("waits for a person: " + std::string{row(fault).meaning} +
                   "; press START, or run: darwinop runtime --reset-faults");
  if (seen.safety.state == darwinop::State::kOffline) {
    // Safety tells of a board that is silent. What was said here before stays said: on a poor cable the board comes and
    // goes many times a minute.
    in_pose_since_.reset();
    return false;
  }
  const bool held =
      darwinop::drives(seen.safety.state) || (seen.safety.state == darwinop::State::kFoundStiff && legsHold(seen));
  return held || sits(seen, now);
}

/// A robot that is held is moved to the start pose slowly, as at any takeover. One that lies limp in some other pose
/// may be in somebody's hands, or on its face.
bool DefaultController::sits(const Sensors& seen, Nanos now) {
  const safety::StartPoseCheck check = safety::checkStartPose(seen);
  if (!check.secure())
    return waitFor("waits until the robot sits upright in its start pose; what is off: darwinop runtime --check-pose",
                   "\n" + safety::describe(check));
  if (!in_pose_since_) in_pose_since_ = now;
  return now - *in_pose_since_ >= kSteady;
}

/// False: there is no user to run it as, and another try would end the same way.
bool DefaultController::chooseAccount(Start& start) {
  try {
    start.account = connect::defaultControllerAccount(connect::readRobotFile());
    return true;
  } catch (const std::runtime_error& error) {
    become(State::kOver, name_ + " is not started: " + error.what());
    return false;
  }
}

void DefaultController::begin(Nanos now) {
  in_pose_since_.reset();
  latched_at_.reset();
  try {
    const std::string place = folder();
    name_ = fs::path{place}.filename();
    Start start;
    start.command = {runtime::controllerProgram(place)};
    start.folder = place;
    start.log = home_ + "/log/controller.log";
    // No start by the supervisor is a person's, the one at boot included: whoever released the robot meanwhile keeps
    // it.
    start.environment = {{"DARWINOP_ROBOT", "runtime"}, {runtime::kUnattended, "1"}};
    start.expendable = true;
    if (geteuid() == 0 && !chooseAccount(start)) return;
    child_ = std::make_unique<Child>(start);
    become(State::kRunning, name_ + " runs (pid " + std::to_string(child_->pid()) + ")");
  } catch (const std::runtime_error& error) {
    say(std::string{"default controller: "} + error.what());
    onEnd({127, false}, now);  // no program to run is as good as one that cannot be run
  }
}

}  // namespace darwinop::supervisor
