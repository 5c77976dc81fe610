// `darwinop motion play`: plays pages or a .motion file and reports loads and errors.
#include "motion_play.hpp"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "connect/setting.hpp"
#include "exit_codes.hpp"
#include "experiments/run/hardware.hpp"
#include "experiments/run/recorded.hpp"
#include "motion_messages.hpp"
#include "motion_own.hpp"
#include "motion_preview.hpp"
#include "motion_stage.hpp"
#include "runtime/recording_file.hpp"
#include "webots/motion_text.hpp"
#include "webots/stop_signals.hpp"
#include "webots/tool_robot.hpp"

namespace darwinop::motion {

namespace {

/// Also validates the file, so that nothing moves if it is invalid.
std::string checkedPreview(const PlayRequest& request, bool is_motion) {
  if (is_motion) {
    if (!request.pages.empty())
      throw std::runtime_error(request.file + ": a .motion file has no pages; leave PAGE out");
    return previewOf(webots_api::readMotion(request.file), request.file);
  }
  if (request.pages.empty())
    throw std::runtime_error("PAGE is missing; list the pages with 'darwinop motion list " + request.file + "'");
  const PageFile pages = openMotions(request.file).pages;
  for (const int page : request.pages) (void)usedPage(pages, page, request.file);
  return previewOf(pages, request.pages);
}

/// Confirmed by --yes or interactively.
bool agreed(const PlayRequest& request) {
  if (request.yes) return true;
  if (isatty(STDIN_FILENO) == 1) {
    std::cout << "This moves a real robot. Is nothing in its way, and does a person hold it? y or n: " << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "yes";
  }
  std::cerr << "darwinop motion: this moves a real robot, as shown above. Make sure that nothing is in its way and "
               "that a person "
               "holds it, then add --yes\n";
  return false;
}

/// False if the robot or the user has ended it. On return the robot is at rest and the recording complete.
bool playAll(const PlayRequest& request, bool is_motion) {
  webots_api::ToolRobot robot;
  PlayStage stage{robot};
  std::cout << kReady << std::endl;
  bool whole = true;
  if (is_motion) whole = stage.motion(request.file);
  for (std::size_t i = 0; whole && i < request.pages.size(); ++i) whole = stage.page(request.file, request.pages[i]);
  const double seconds = stage.seconds();
  whole = whole && stage.waitUntilSettled();
  stage.printSummary(seconds);
  return whole;
}

int perform(const PlayRequest& request, bool is_motion) {
  const bool whole = playAll(request, is_motion);
  const bool is_recorded = experiments::reportRecording(request.record);
  if (whole) return is_recorded ? app::kDone : app::kFailed;
  std::cerr << (webots_api::stopRequested() ? kStoppedOnRequest : "ended by the robot, see above\n");
  return webots_api::stopRequested() ? app::kStopped : app::kFailed;
}

void setForRobot(const char* name, const std::string& value) {
  if (!value.empty()) setenv(name, value.c_str(), 1);
}

}  // namespace

int play(PlayRequest request) {
  runtime::requireNewRecording(request.record);
  const bool is_motion = isMotionOfWebots(request.file);
  const std::string preview = checkedPreview(request, is_motion);
  if (const char* usual = std::getenv("DARWINOP_ROBOT"); request.robot.empty() && usual != nullptr)
    request.robot = usual;
  if (request.robot.empty()) request.robot = "twin";
  const connect::Setting robot = connect::readSetting(request.robot);
  std::cout << preview << "on: " << request.robot << std::endl;
  if (experiments::mayBeHardware(request.robot) && !agreed(request)) return app::kNeedsYes;
  if (connect::loopIsElsewhere(robot) && !request.record.empty())
    throw std::runtime_error(
        "the loop of this robot runs in the daemon, which writes recordings itself: start it with darwinop runtime "
        "--record FILE");
  setForRobot("DARWINOP_ROBOT", request.robot);
  if (request.period_ms != 0) setForRobot("DARWINOP_PERIOD_MS", std::to_string(request.period_ms));
  unsetenv("DARWINOP_RECORD");
  setForRobot("DARWINOP_RECORD", request.record);
  setenv("DARWINOP_KEEP_CWD", "1", 1);  // file names are relative to the user's folder
  return perform(request, is_motion);
}

}  // namespace darwinop::motion
