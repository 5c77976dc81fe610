// When the default controller may begin, and how it does.
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "runtime/controller_run.hpp"
#include "runtime/file_lock.hpp"
#include "safety/start_pose.hpp"
#include "supervisor/default_controller.hpp"

namespace darwinop::supervisor {
namespace {

namespace fs = std::filesystem;

// A robot that somebody is just setting down passes through the start pose.
constexpr Nanos kSteady{1'000'000'000};

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
  if (seen.safety.state == darwinop::State::kOffline) {
    // Safety tells of a board that is silent. What was said here before stays said: on a poor cable the board comes and
    // goes many times a minute.
    in_pose_since_.reset();
    return false;
  }
  return seen.safety.state != darwinop::State::kLimp || sits(seen, now);
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

void DefaultController::begin(Nanos now) {
  in_pose_since_.reset();
  try {
    const std::string place = folder();
    name_ = fs::path{place}.filename();
    Start start;
    start.command = {runtime::controllerProgram(place)};
    start.folder = place;
    start.log = home_ + "/log/controller.log";
    start.environment = {{"DARWINOP_ROBOT", "runtime"}};
    start.expendable = true;
    child_ = std::make_unique<Child>(start);
    become(State::kRunning, name_ + " runs (pid " + std::to_string(child_->pid()) + ")");
  } catch (const std::runtime_error& error) {
    say(std::string{"default controller: "} + error.what());
    onEnd({127, false}, now);  // no program to run is as good as one that cannot be run
  }
}

}  // namespace darwinop::supervisor
