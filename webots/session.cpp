// Session of a controller.
#include "webots/session.hpp"

#include <algorithm>
#include <utility>

#include "connect/camera.hpp"
#include "webots/messages.hpp"
#include "webots/notices.hpp"

namespace darwinop::webots_api {

namespace {
constexpr Nanos kBeat = std::chrono::milliseconds{200};
constexpr Nanos kQuiet = std::chrono::seconds{3};      // then log what is being waited for
constexpr Nanos kPatience = std::chrono::seconds{30};  // for a robot that does not start to move
constexpr Nanos kLongest = std::chrono::seconds{180};  // 6 rad at the slowest gentle_speed, 0.05 rad/s, plus margin

/// Joints that did not reach the start pose; empty: all did.
std::string startMissedBy(const SafetyReport& report) {
  std::string names;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (report.missed_start[i]) names += (names.empty() ? "" : ", ") + std::string{kJointTable[i].name};
  return names;
}

std::string whatIsAwaited(const SafetyReport& report) {
  const auto state = static_cast<std::size_t>(report.state);
  std::string text = "the robot is " + std::string{kStateNames[std::min(state, kStates - 1)]};
  if (report.worst != Fault::kNone) text += ": " + runtime::describe(report);
  return text;
}
}  // namespace

Session::Session(std::unique_ptr<runtime::RobotLink> link, const std::atomic<bool>& stop)
    : driver_{std::move(link)}, stop_{stop} {}

std::unique_ptr<FrameSource> Session::openCamera(int width, int height, const v4l2::CameraSettings& settings) {
  return connect::openCamera(
      driver_.link(), {.width = width, .height = height, .settings = settings, .log = [](const std::string& what) {
                         logLine("Camera: " + what);
                       }});
}

std::string Session::begin(const Commands& first) {
  const Nanos started = driver_.link().now();
  driver_.start();
  bool logged = false;
  for (;;) {
    driver_.publish(first);
    if (!driver_.waitForCycle(driver_.sensors().cycle + 1, stop_))
      return stop_ ? messages::kAskedToEnd : driver_.link().whyEnded();
    sensors_ = driver_.sensors();
    if (std::string why = driver_.faultEnd(sensors_); !why.empty()) return why;
    if (driver_.drives(sensors_)) break;
    const Nanos waited = driver_.link().now() - started;
    const State state = sensors_.safety.state;
    if (waited > (state == State::kStarting ? kLongest : kPatience))
      return "the robot is not ready; " + whatIsAwaited(sensors_.safety);
    if (waited > kQuiet && !logged && state == State::kOffline) {
      logLine("waiting: " + whatIsAwaited(sensors_.safety));
      logged = true;
    }
  }
  if (const std::string names = startMissedBy(sensors_.safety); !names.empty())
    logLine("not in the start pose after the slow move to it: " + names + "; " +
            std::string{row(Fault::kStartMissed).remedy});
  line_ = TimeLine{driver_.link().period(), sensors_.cycle};
  origin_ = Nanos{sensors_.time_ns};
  returned_ = driver_.link().now();
  return {};
}

Nanos Session::time() const {
  return reached_ + (driver_.link().realTime() ? driver_.link().now() - returned_ : Nanos{0});
}

void Session::publish(const Commands& commands, int ms) {
  if (ended_) return;
  driver_.publish(commands);
  asked_ = commands;
  const std::chrono::milliseconds step{std::max(ms, 0)};
  target_ = line_.advance(step);
  due_ = returned_ + step;
}

int Session::wait() {
  if (ended_) return -1;
  if (stop_) return end({});
  Nanos late{0};
  const Nanos before = time();
  if (driver_.sensors().cycle < target_) {
    if (!waitForTarget()) return end(stop_ ? std::string{} : driver_.link().whyEnded());
    sensors_ = driver_.sensors();
    reached_ = std::max(before, Nanos{sensors_.time_ns} - origin_);  // never back, if its bus exchange took longer
    if (sensors_.cycle > target_ &&
        driver_.link().realTime()) {  // the wait took longer than the step, as in a slow network
      late = driver_.link().now() - due_;
      line_.restartAt(sensors_.cycle);
    }
  } else {
    sensors_ = driver_.sensors();
    reached_ = std::max(before, Nanos{sensors_.time_ns} - origin_);
    late = driver_.link().now() - due_;
    if (sensors_.cycle > target_) line_.restartAt(sensors_.cycle);
  }
  returned_ = driver_.link().now();
  if (const std::string why = driver_.faultEnd(sensors_); !why.empty()) return end(why);
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(late).count();
  return static_cast<int>(std::clamp<std::int64_t>(ms, 0, 1'000'000'000));
}

/// Sends heartbeats during a long step: safety holds the robot if a controller is silent for 500 ms.
bool Session::waitForTarget() {
  const auto beat = static_cast<std::uint64_t>(std::max<Nanos::rep>(1, kBeat / driver_.link().period()));
  for (std::uint64_t now = driver_.sensors().cycle; now < target_; now = driver_.sensors().cycle) {
    if (!driver_.waitForCycle(std::min(target_, now + beat), stop_)) return false;
    if (now + beat < target_) driver_.publish(asked_);
  }
  return true;
}

bool Session::carryOn(const Commands& commands, Nanos step) {
  const Sensors before = driver_.sensors();
  const Nanos began = time();
  if (!executes(before)) return false;
  // The commands of an interrupted step come first: those of two steps in one cycle would be a jump.
  if (std::exchange(target_, 0) > before.cycle && !reaches(before.cycle + 1)) return false;
  line_.restartAt(driver_.sensors().cycle);
  driver_.publish(commands);
  if (!reaches(line_.advance(step))) return false;
  sensors_ = driver_.sensors();
  reached_ = std::max(began, Nanos{sensors_.time_ns} - origin_);
  returned_ = driver_.link().now();
  return executes(sensors_);
}

/// The request to end a runtime is reported once, and does not end the last steps.
bool Session::reaches(std::uint64_t cycle) {
  return driver_.waitForCycle(cycle) || driver_.waitForCycle(cycle);
}

bool Session::executes(const Sensors& seen) const {
  return driver_.drives(seen) && driver_.faultEnd(seen).empty();
}

int Session::end(const std::string& sentence) {
  ended_ = true;
  if (!sentence.empty()) logLine(sentence);
  return -1;
}

}  // namespace darwinop::webots_api
