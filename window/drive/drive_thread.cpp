// Thread that runs a drive session cycle by cycle.
#include "window/drive/drive_thread.hpp"

#include <exception>
#include <stdexcept>

#include "window/drive/drive_timers.hpp"
#include "window/drive/motion_planner.hpp"
#include "window/messages.hpp"

namespace darwinop::window {
DriveThread::~DriveThread() {
  finish();
  if (thread_.joinable()) thread_.join();
}

void DriveThread::start() {
  if (thread_.joinable()) thread_.join();  // kFree: the thread has ended
  const std::scoped_lock lock{mutex_};
  requests_ = {};
  report_ = {};
  handleLocked(DriveEvent::kStartAsked, {});
  thread_ = std::thread{[this] {
    try {
      driveSession();
      handle(DriveEvent::kReleased);
    } catch (const std::exception& error) {
      handle(DriveEvent::kReleased, error.what());
    }
  }};
}

void DriveThread::request(const DriveRequests& requests) {
  const std::scoped_lock lock{mutex_};
  requests_.merge(requests);
  last_request_ = clock_.now();
}

DriveInterface::Report DriveThread::report() {
  const std::scoped_lock lock{mutex_};
  return report_;
}

void DriveThread::handle(DriveEvent event, const std::string& why) {
  const std::scoped_lock lock{mutex_};
  handleLocked(event, why);
}

void DriveThread::handleLocked(DriveEvent event, const std::string& why) {
  const DriveState after = next(report_.state, event);
  if (after != report_.state && !why.empty()) report_.why = why;
  report_.state = after;
  if (event == DriveEvent::kTorqueOn) last_request_ = clock_.now();  // requests were not required so far
}

std::optional<DriveRequests> DriveThread::takeRequests() {
  const std::scoped_lock lock{mutex_};
  if (clock_.now() - last_request_ > kRequestTimeout) handleLocked(DriveEvent::kRequestsMissed, messages::kNoRequests);
  if (report_.state == DriveState::kHolding) return std::nullopt;
  if (report_.state == DriveState::kEnding) return DriveRequests{};  // request nothing: stand
  const DriveRequests now = requests_;
  requests_.clearOneTime();
  return now;
}

/// Throws std::runtime_error if there is no session to drive.
void DriveThread::driveSession() {
  runtime::DriverSession session{connect_()};
  session.start();
  Commands commands{};
  commands.start_where_it_is = true;  // no move to the start pose before a limb is dragged
  try {
    runCycles(session, commands);
  } catch (const std::exception& error) {
    handle(DriveEvent::kFailed, error.what());
  }
  session.hold(commands);
}

/// Throws std::runtime_error with the reason if the robot ends the session.
void DriveThread::runCycles(runtime::DriverSession& session, Commands& commands) {
  MotionPlanner planner{*pages_};
  DriveTimers timers;
  std::uint64_t cycle = session.sensors().cycle;
  while (const std::optional<DriveRequests> requests = takeRequests()) {
    const Sensors seen = session.sensors();
    const double ms = static_cast<double>(static_cast<std::int64_t>(seen.cycle - cycle) * seen.period_ns) * 1e-6;
    cycle = seen.cycle;
    commands.joint = planner.plan(*requests, seen, ms).joint;
    session.publish(commands);
    {
      const std::scoped_lock lock{mutex_};
      report_.status = planner.status();
      const auto event = timers.advance(report_.state, session.drives(seen), planner.status().walks, ms);
      if (event) handleLocked(*event, event == DriveEvent::kFailed ? messages::kNoTorque : "");
      if (report_.state == DriveState::kHolding) return;
    }
    const bool loop_runs = session.waitForCycle(cycle + 1);
    if (const std::string why = session.faultEnd(session.sensors()); !why.empty()) throw std::runtime_error(why);
    if (!loop_runs) throw std::runtime_error(session.link().whyEnded());
  }
}

}  // namespace darwinop::window
