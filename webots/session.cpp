// A controller's time with a robot: publish, wait, read one consistent image, know when to end.
#include "webots/session.hpp"

#include <algorithm>

#include "connect/camera.hpp"
#include "webots/notices.hpp"

namespace darwinop::facade {

namespace {
constexpr Nanos kBeat = std::chrono::milliseconds{200};
constexpr Nanos kQuiet = std::chrono::seconds{3};      // then say what is being waited for
constexpr Nanos kPatience = std::chrono::seconds{30};  // for a robot that does not even start to move
constexpr Nanos kLongest = std::chrono::seconds{180};  // 6 rad at the slowest gentle_speed, 0.05 rad/s, and some

std::string describe(const SafetyReport& report) {
  const FaultRow& fault = row(report.worst);
  std::string text{fault.meaning};
  if (report.worst_joint >= 1 && report.worst_joint <= kJoints)
    text += " (" + std::string{kJointTable[report.worst_joint - 1U].name} + ", id " +
            std::to_string(report.worst_joint) + ")";
  return text + "; " + std::string{fault.remedy};
}

/// Joints that did not get to the start pose; empty: all did.
std::string startMissedBy(const SafetyReport& report) {
  std::string names;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (report.missed_start[i]) names += (names.empty() ? "" : ", ") + std::string{kJointTable[i].name};
  return names;
}

std::string whatIsAwaited(const SafetyReport& report) {
  const auto state = static_cast<std::size_t>(report.state);
  std::string text = "the robot is " + std::string{kStateNames[std::min(state, kStates - 1)]};
  if (report.worst != Fault::kNone) text += ": " + describe(report);
  return text;
}
}  // namespace

Session::Session(std::unique_ptr<runtime::RobotLink> link, const std::atomic<bool>& stop)
    : link_{std::move(link)}, stop_{stop} {}

std::unique_ptr<FrameSource> Session::openCamera(int width, int height, const v4l2::CameraSettings& settings) {
  return connect::openCamera(
      *link_, {.width = width, .height = height, .settings = settings, .log = [](const std::string& what) {
                 logLine("Camera: " + what);
               }});
}

std::string Session::begin(const Commands& first) {
  const Nanos started = link_->now();
  // The cycle under way may have begun before the first image was there: only the one after it speaks of us.
  const std::uint64_t first_of_ours = link_->sensors().cycle + 2;
  bool logged = false;
  for (;;) {
    link_->publish(first);
    if (!link_->waitForCycle(link_->sensors().cycle + 1, stop_))
      return stop_ ? "asked to end before the robot was ready" : link_->whyEnded();
    sensors_ = link_->sensors();
    if (sensors_.cycle >= first_of_ours) {
      if (sensors_.safety.controller_must_end) return describe(sensors_.safety);
      if (sensors_.safety.state == State::kDriven) break;
    }
    const Nanos waited = link_->now() - started;
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
  line_ = TimeLine{link_->period(), sensors_.cycle};
  origin_ = Nanos{sensors_.time_ns};
  returned_ = link_->now();
  return {};
}

Nanos Session::time() const {
  return reached_ + (link_->realTime() ? link_->now() - returned_ : Nanos{0});
}

void Session::publish(const Commands& commands, int ms) {
  if (ended_) return;
  link_->publish(commands);
  asked_ = commands;
  const std::chrono::milliseconds step{std::max(ms, 0)};
  target_ = line_.advance(step);
  due_ = returned_ + step;
}

int Session::wait() {
  if (ended_) return -1;
  if (stop_) return end({});
  Nanos late{0};
  if (link_->sensors().cycle < target_) {
    if (!waitForTarget()) return end(stop_ ? std::string{} : link_->whyEnded());
    sensors_ = link_->sensors();
    reached_ = Nanos{sensors_.time_ns} - origin_;
    if (sensors_.cycle > target_ &&
        link_->realTime()) {  // waited for longer than the step takes, as a slow network does
      late = link_->now() - due_;
      line_.restartAt(sensors_.cycle);
    }
  } else {
    sensors_ = link_->sensors();
    reached_ = std::max(time(), Nanos{sensors_.time_ns} - origin_);
    late = link_->now() - due_;
    if (sensors_.cycle > target_) line_.restartAt(sensors_.cycle);
  }
  returned_ = link_->now();
  if (sensors_.safety.controller_must_end) return end(describe(sensors_.safety));
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(late).count();
  return static_cast<int>(std::clamp<std::int64_t>(ms, 0, 1'000'000'000));
}

/// A controller inside a long step is alive, and says so: safety holds the robot of one that is silent for 500 ms.
bool Session::waitForTarget() {
  const auto beat = static_cast<std::uint64_t>(std::max<Nanos::rep>(1, kBeat / link_->period()));
  for (std::uint64_t now = link_->sensors().cycle; now < target_; now = link_->sensors().cycle) {
    if (!link_->waitForCycle(std::min(target_, now + beat), stop_)) return false;
    if (now + beat < target_) link_->publish(asked_);
  }
  return true;
}

int Session::end(const std::string& sentence) {
  ended_ = true;
  if (!sentence.empty()) logLine(sentence);
  return -1;
}

}  // namespace darwinop::facade
