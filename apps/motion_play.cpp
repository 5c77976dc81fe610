// `darwinop motion play`: plays pages or a .motion file, and says at its end what that did to the robot.
#include "motion_play.hpp"

#include <unistd.h>

#include <DARwInOPMotionManager.hpp>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <webots/Robot.hpp>
#include <webots/utils/Motion.hpp>

#include "connect/setting.hpp"
#include "experiments/run/hardware.hpp"
#include "managers/motion_text/values.hpp"
#include "managers/motion_watch/motion_watch.hpp"
#include "managers/motion_watch/posture.hpp"
#include "motion_own.hpp"
#include "motion_preview.hpp"
#include "webots/robot_impl.hpp"
#include "webots/stop_signals.hpp"

namespace darwinop::motion {

namespace {

constexpr double kSettle = 1.0;  // s behind the last goal, for the body to come to rest

bool isMotionFile(const std::string& file) {
  if (file == kOwn) return false;
  const std::vector<std::uint8_t> bytes = readBytes(file);
  constexpr std::string_view kHead = "#WEBOTS_MOTION";
  return std::string_view{reinterpret_cast<const char*>(bytes.data()), bytes.size()}.starts_with(kHead);
}

/// Checks the file, too: nothing moves when it is wrong.
std::string checkedPreview(const PlayRequest& request, bool is_motion) {
  if (is_motion) {
    if (!request.pages.empty())
      throw std::runtime_error(request.file + ": a .motion file has no pages; leave PAGE out");
    return previewOf(facade::readMotion(request.file), request.file);
  }
  if (request.pages.empty())
    throw std::runtime_error("which page? 'darwinop motion list " + request.file + "' shows what there is");
  const PageFile pages = openMotions(request.file).pages;
  for (const int page : request.pages) (void)usedPage(pages, page, request.file);
  return previewOf(pages, request.pages);
}

/// A person has agreed, by --yes or with a y at a terminal.
bool agreed(const PlayRequest& request) {
  if (request.yes) return true;
  if (isatty(STDIN_FILENO) == 1) {
    std::cout << "This moves a real robot. Is nothing in its way, and does somebody hold it? y or n: " << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "yes";
  }
  std::cerr << "darwinop motion: this would move a real robot, as shown above. If nothing is in its way and somebody "
               "holds it, say so with --yes\n";
  return false;
}

/// One robot, one movement after the other.
class Stage {
 public:
  /// False: the robot or the user has ended it.
  bool page(const std::string& file, int number) {
    if (!manager_) manager_ = std::make_unique<managers::DARwInOPMotionManager>(&robot_, file);
    manager_->playPage(number, false);
    if (!manager_->isMotionPlaying()) return false;  // it said why
    while (manager_->isMotionPlaying()) {
      manager_->step(step_ms_);
      if (!step()) return false;
    }
    return true;
  }
  bool motion(const std::string& file) {
    webots::Motion motion{file};
    motion.play();
    do
      if (!step()) return false;
    while (!motion.isOver());
    return true;
  }
  bool settle() {
    for (const double end = robot_.getTime() + kSettle; robot_.getTime() < end;)
      if (!step()) return false;
    return true;
  }

  void tell(double seconds) const {
    std::cout << "played for " << fixed(seconds, 1) << " s; greatest distance from the goal, greatest load:\n"
              << watch_.jointsText() << watch_.faultsText() << "the robot " << textOf(postureOf(sensors()))
              << std::endl;
  }
  [[nodiscard]] double seconds() const { return robot_.getTime() - began_; }

 private:
  bool step() {
    if (robot_.step(step_ms_) == -1) return false;
    watch_.look(sensors(), seconds());
    return true;
  }
  static const Sensors& sensors() { return facade::currentRobot()->session().sensors(); }

  webots::Robot robot_;
  const int step_ms_ = static_cast<int>(robot_.getBasicTimeStep());
  const double began_ = robot_.getTime();
  std::unique_ptr<managers::DARwInOPMotionManager> manager_;
  MotionWatch watch_;
};

int perform(const PlayRequest& request, bool is_motion) {
  Stage stage;
  std::cout << "the robot is ready; Ctrl-C ends it" << std::endl;
  bool whole = true;
  if (is_motion) whole = stage.motion(request.file);
  for (std::size_t i = 0; whole && i < request.pages.size(); ++i) whole = stage.page(request.file, request.pages[i]);
  const double seconds = stage.seconds();
  whole = whole && stage.settle();
  stage.tell(seconds);
  if (!request.record.empty()) std::cout << "recorded: " << request.record << std::endl;
  if (whole) return kPlayed;
  std::cerr << (facade::stopRequested() ? "stopped when asked to\n" : "the robot ended it, as said above\n");
  return facade::stopRequested() ? kPlayStopped : kPlayEnded;
}

void setForRobot(const char* name, const std::string& value) {
  if (!value.empty()) setenv(name, value.c_str(), 1);
}

}  // namespace

int play(PlayRequest request) {
  const bool is_motion = isMotionFile(request.file);
  const std::string preview = checkedPreview(request, is_motion);
  if (const char* usual = std::getenv("DARWINOP_ROBOT"); request.robot.empty() && usual != nullptr)
    request.robot = usual;
  if (request.robot.empty()) request.robot = "twin";
  const connect::Setting robot = connect::readSetting(request.robot);
  std::cout << preview << "on: " << request.robot << std::endl;
  if (experiments::mayBeHardware(request.robot) && !agreed(request)) return kPlayNeedsYes;
  if (connect::loopIsElsewhere(robot) && !request.record.empty())
    throw std::runtime_error(
        "the loop of this robot runs in its daemon, which makes recordings by itself: start that with darwinop runtime "
        "--record FILE");
  setForRobot("DARWINOP_ROBOT", request.robot);
  if (request.period_ms != 0) setForRobot("DARWINOP_PERIOD_MS", std::to_string(request.period_ms));
  unsetenv("DARWINOP_RECORD");
  setForRobot("DARWINOP_RECORD", request.record);
  setenv("DARWINOP_KEEP_CWD", "1", 1);  // names of files are the user's
  return perform(request, is_motion);
}

}  // namespace darwinop::motion
