// darwinop-virtual-camera: a simulated V4L2 camera for programs with the preloaded shim.
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "hal/process/child_process.hpp"
#include "hal/signals.hpp"
#include "hil-mocks/camera/camera_fault.hpp"
#include "hil-mocks/camera/camera_settings.hpp"
#include "hil-mocks/camera/frame_painter.hpp"
#include "hil-mocks/camera/picture_folder.hpp"
#include "hil-mocks/camera/test_pattern.hpp"
#include "parse_arguments.hpp"
#include "wrong_argument.hpp"

namespace {

namespace hil = darwinop::hil;
using Clock = std::chrono::steady_clock;
using darwinop::process::ChildProcess;
using Seconds = std::chrono::duration<double>;

constexpr double kFramesPerSecond = 30;
constexpr double kPatienceS = 5;   // grace period after SIGTERM
constexpr int kCannotStart = 127;  // as in shells

struct Arguments {
  std::string pattern = "ball", pictures, file, device = "/dev/video0", fault = "none";
  std::uint32_t frames_each = 30;
  double for_s = 0, fault_at_s = 0, fault_for_s = 0;
  std::vector<std::string> command;
};

void describe(CLI::App& app, Arguments& a) {
  std::vector<std::string> faults;
  for (const hil::CameraFaultRow& row : hil::kCameraFaults) faults.emplace_back(row.name);
  auto* const pattern = app.add_option("--pattern", a.pattern, "Test pattern: ball on a circle, or colour bars")
                            ->check(CLI::IsMember({"ball", "bars"}))
                            ->capture_default_str();
  app.add_option("--pictures", a.pictures, "Show the PNG and PPM files of this folder instead, in name order")
      ->excludes(pattern);
  app.add_option("--frames-each", a.frames_each, "Number of frames for each picture")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--device", a.device, "Path of the camera device")->capture_default_str();
  app.add_option("--file", a.file, "Frame file to create, and to remove at the end (default: one in /dev/shm)");
  app.add_option("--fault", a.fault, "Fault of the camera, see docs/virtual-camera.md")
      ->check(CLI::IsMember(faults))
      ->capture_default_str();
  app.add_option("--fault-at", a.fault_at_s, "Start of the fault in seconds")->check(CLI::Range(0.0, 1e6));
  app.add_option("--fault-for", a.fault_for_s, "Duration of the fault in seconds")->check(CLI::Range(0.01, 1e6));
  app.add_option("--for", a.for_s, "Duration in seconds")->check(CLI::Range(0.01, 1e6));
  app.footer(
      "-- COMMAND ARGUMENTS... starts a program that sees the camera. This program then runs as long "
      "as the command and returns its exit status.\n\nExample:\n"
      "  darwinop-virtual-camera --pattern bars -- v4l2-ctl --stream-mmap --stream-count=90\n");
}

class Studio {
 public:
  explicit Studio(const Arguments& a) : arguments_{a}, painter_{a.file} {
    if (!a.pictures.empty()) darwinop::app::fromArguments([&] { folder_.emplace(a.pictures, a.frames_each); });
    paint(0);
  }

  void paint(double seconds) {
    const Arguments& a = arguments_;
    const bool faulty = seconds >= a.fault_at_s && (a.fault_for_s <= 0 || seconds < a.fault_at_s + a.fault_for_s);
    painter_.setFault(faulty ? *hil::cameraFault(a.fault) : hil::CameraFault::kNone);
    const hil::PictureSize size = painter_.wanted();
    if (picture_.width != size.width || picture_.height != size.height) picture_ = {size.width, size.height};
    if (folder_)
      folder_->draw(picture_, painter_.painted());
    else if (a.pattern == "bars")
      hil::drawBars(picture_, painter_.painted());
    else
      hil::drawBall(picture_, seconds);
    painter_.paint(size, picture_.bgra);
  }

 private:
  const Arguments& arguments_;
  hil::FramePainter painter_;
  std::optional<hil::PictureFolder> folder_;
  hil::PaintedPicture picture_{2, 2};
};

/// Paints until the command ends, a signal arrives or the time is over. `child` null: no command.
int paintOn(Studio& studio, const Arguments& a, const sigset_t& signals, ChildProcess* child) {
  const Clock::time_point begin = Clock::now();
  double end_s = a.for_s > 0 ? a.for_s : 1e9;
  bool term_sent = false;
  for (std::uint64_t frame = 1;; ++frame) {
    const double now_s = Seconds(Clock::now() - begin).count();
    frame = std::max(frame, static_cast<std::uint64_t>(now_s * kFramesPerSecond));  // late: skip frames
    const double wait_s = std::clamp(static_cast<double>(frame) / kFramesPerSecond - now_s, 0.0, 1.0);
    const timespec wait{0, static_cast<long>(std::min(wait_s, 0.999) * 1e9)};
    siginfo_t info = {};
    const int signal = sigtimedwait(&signals, &info, &wait);
    if (child != nullptr && child->ended()) return child->ended()->shellStatus();
    const bool asked = std::ranges::find(darwinop::kEndSignals, signal) != darwinop::kEndSignals.end();
    const bool over = now_s >= end_s;
    if (child == nullptr && (asked || over)) return 0;
    if (asked && info.si_code != SI_KERNEL) child->signal(signal);  // the terminal has signalled the command already
    if (over) {
      child->signal(term_sent ? SIGKILL : SIGTERM);
      term_sent = true;
      end_s = now_s + kPatienceS;
    }
    if (signal < 0) studio.paint(now_s);
  }
}

int serve(Arguments& a) {
  if (a.file.empty()) a.file = "/dev/shm/darwinop-camera-" + std::to_string(getpid());
  a.file = std::filesystem::absolute(a.file);
  const std::vector<std::string> environment = darwinop::hil::cameraSettings(a.file, a.device);
  sigset_t signals = darwinop::blockEndSignals();
  sigaddset(&signals, SIGCHLD);
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  Studio studio{a};
  if (a.command.empty()) {
    std::printf("camera: %s, for programs started with\n", a.device.c_str());
    for (const std::string& setting : environment) std::printf("export %s\n", setting.c_str());
    std::fflush(stdout);
    return paintOn(studio, a, signals, nullptr);
  }
  std::optional<ChildProcess> child;
  try {
    child.emplace(
        darwinop::process::Start{.command = a.command,
                                 .environment = environment,
                                 .ends_with_us = true,  // else nothing would end it: only we forward signals to it
                                 .keeps_ignored_signals = true});
  } catch (const std::system_error& error) {
    std::fprintf(stderr, "darwinop virtual-camera: %s\n", error.what());
    return kCannotStart;
  }
  return paintOn(studio, a, signals, &*child);
}

int run(int argc, char** argv) {
  CLI::App app{"Simulates the robot's camera for selected programs.", "darwinop virtual-camera"};
  Arguments arguments;
  describe(app, arguments);
  app.set_version_flag("--version", DARWINOP_VERSION);
  char** const dashes = std::find_if(argv, argv + argc, [](const char* word) { return std::strcmp(word, "--") == 0; });
  if (dashes != argv + argc) arguments.command.assign(dashes + 1, argv + argc);
  if (const auto code = darwinop::app::parseArguments(app, static_cast<int>(dashes - argv), argv)) return *code;
  return serve(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "darwinop virtual-camera: %s\n", error.what());
    return darwinop::app::exitCodeOf(error);
  }
}
