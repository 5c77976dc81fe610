// Thread that runs a drive session cycle by cycle.
#include "window/drive_thread.hpp"

#include <exception>
#include <stdexcept>
#include <utility>

#include "window/motion_planner.hpp"

namespace darwinop::window {
namespace {

constexpr const char* kNoRequests = "the window's program did not respond for 0.8 s. The robot holds.";

constexpr bool kStartWhereItIs = true;  // no move to the start pose before a limb is dragged
constexpr double kSettleMs = 300;       // ms after the last step, so that joints arrive before they are held
constexpr double kLongestEndMs = 6000;  // ms for the last steps and the stance; then the robot is held in any case

}  // namespace

DriveThread::DriveThread(remote::LinkPort::Connect connect, const motion::PageFile& pages)
    : port_{remote::LinkPort::Home::kDaemon, std::move(connect), kStartWhereItIs}, pages_{&pages} {}

DriveThread::~DriveThread() {
  finish();
  if (thread_.joinable()) thread_.join();
}

void DriveThread::start() {
  if (thread_.joinable()) thread_.join();  // kFree: the thread has ended
  stop_ = false;
  const std::scoped_lock lock{mutex_};
  requests_ = {};
  finishing_ = timed_out_ = false;
  report_ = {.state = State::kStarting};
  last_request_ = clock_.now();
  thread_ = std::thread{[this] { drive(); }};
}

void DriveThread::request(const DriveRequests& requests) {
  const std::scoped_lock lock{mutex_};
  requests_.merge(requests);
  last_request_ = clock_.now();
}

void DriveThread::stop() {
  stop_ = true;
  finish();
}

void DriveThread::finish() {
  const std::scoped_lock lock{mutex_};
  finishing_ = true;
  if (report_.state != State::kFree) report_.state = State::kEnding;
}

DriveInterface::Report DriveThread::report() {
  const std::scoped_lock lock{mutex_};
  return report_;
}

void DriveThread::setState(State state, const std::string& why) {
  const std::scoped_lock lock{mutex_};
  report_ = {.state = state, .why = why};
}

std::optional<DriveRequests> DriveThread::takeRequests() {
  const std::scoped_lock lock{mutex_};
  if (stop_) return std::nullopt;
  if (report_.state == State::kDriving && clock_.now() - last_request_ > kRequestTimeout) {
    finishing_ = timed_out_ = true;
    report_.state = State::kEnding;
    report_.why = kNoRequests;
  }
  if (finishing_) return DriveRequests{};  // request nothing: stand
  DriveRequests now = requests_;
  requests_.clearOneTime();
  return now;
}

void DriveThread::drive() {
  try {
    port_.startSession(remote::SessionStart::kNew);
  } catch (const std::exception& error) {
    return setState(State::kFree, error.what());
  }
  std::string why;
  try {
    runCycles();
  } catch (const std::exception& error) {
    why = error.what();
  }
  port_.hold();
  setState(State::kFree, why.empty() && timed_out_ ? kNoRequests : why);
}

/// Whether the robot is driven by now. The heartbeat is required from then on.
bool DriveThread::checkDriven(const Sensors& seen) {
  if (seen.cycle < port_.firstSessionCycle() || seen.safety.state != darwinop::State::kDriven) return false;
  const std::scoped_lock lock{mutex_};
  if (!finishing_) report_.state = State::kDriving;
  last_request_ = clock_.now();
  return true;
}

/// Throws std::runtime_error with the reason if the robot ends the session.
void DriveThread::runCycles() {
  MotionPlanner planner{*pages_};
  std::uint64_t cycle = port_.sensors().cycle;
  double ending_ms = 0, settling_ms = 0, takeover_ms = 0;
  bool driving = false;
  while (const std::optional<DriveRequests> requests = takeRequests()) {
    const Sensors seen = port_.sensors();
    const double ms = static_cast<double>(static_cast<std::int64_t>(seen.cycle - cycle) * seen.period_ns) * 1e-6;
    cycle = seen.cycle;
    driving = driving || checkDriven(seen);
    if (!driving && (takeover_ms += ms) > kTakeoverTimeoutMs)
      throw std::runtime_error("torque did not come on; check the servo power switch and the Faults tab");
    port_.publish(planner.plan(*requests, seen, ms));
    bool finishing = false;
    {
      const std::scoped_lock lock{mutex_};
      report_.status = planner.status();
      finishing = finishing_;
    }
    if (planner.status().walks) settling_ms = kSettleMs;
    if (finishing && ((!planner.status().walks && (settling_ms -= ms) <= 0) || (ending_ms += ms) > kLongestEndMs))
      return;
    port_.waitForNextCycle();
    if (const std::string why = port_.endReason(); !why.empty()) throw std::runtime_error(why);
  }
}

}  // namespace darwinop::window
