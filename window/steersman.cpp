#include "window/steersman.hpp"

#include <exception>
#include <stdexcept>
#include <utility>

#include "window/moves.hpp"

namespace darwinop::window {
namespace {

constexpr const char* kWasDeaf = "this window's program did not answer for 0.8 s. The robot holds.";

constexpr bool kWhereItIs = true;       // who drags an arm does not want the robot to kneel first
constexpr double kSettleMs = 300;       // after the last step, for joints on their way: they are held where they are
constexpr double kLongestEndMs = 6000;  // of steps and the way to the stance; then it is held all the same

}  // namespace

Steersman::Steersman(remote::LinkPort::Connect connect, const motion::PageFile& pages)
    : port_{remote::LinkPort::Home::kDaemon, std::move(connect), kWhereItIs}, pages_{&pages} {}

Steersman::~Steersman() {
  leave();
  if (thread_.joinable()) thread_.join();
}

void Steersman::begin() {
  if (thread_.joinable()) thread_.join();  // it has ended: we are free
  stop_ = false;
  const std::scoped_lock lock{mutex_};
  orders_ = {};
  leaving_ = deaf_ = false;
  report_ = {.state = State::kAsking};
  heard_ = clock_.now();
  thread_ = std::thread{[this] { drive(); }};
}

void Steersman::order(const Orders& orders) {
  const std::scoped_lock lock{mutex_};
  orders_.add(orders);
  heard_ = clock_.now();
}

void Steersman::stop() {
  stop_ = true;
  leave();
}

void Steersman::leave() {
  const std::scoped_lock lock{mutex_};
  leaving_ = true;
  if (report_.state != State::kFree) report_.state = State::kEnding;
}

Helm::Report Steersman::report() {
  const std::scoped_lock lock{mutex_};
  return report_;
}

void Steersman::tell(State state, const std::string& why) {
  const std::scoped_lock lock{mutex_};
  report_ = {.state = state, .why = why};
}

std::optional<Orders> Steersman::newest() {
  const std::scoped_lock lock{mutex_};
  if (stop_) return std::nullopt;
  if (report_.state == State::kDriving && clock_.now() - heard_ > kDeaf) {
    leaving_ = deaf_ = true;
    report_.state = State::kEnding;
    report_.why = kWasDeaf;
  }
  if (leaving_) return Orders{};  // stand
  Orders now = orders_;
  orders_.taken();
  return now;
}

void Steersman::drive() {
  try {
    port_.begin(remote::Beginning::kFresh);
  } catch (const std::exception& error) {
    return tell(State::kFree, error.what());
  }
  std::string why;
  try {
    driveUntilTheEnd();
  } catch (const std::exception& error) {
    why = error.what();
  }
  port_.hold();
  tell(State::kFree, why.empty() && deaf_ ? kWasDeaf : why);
}

/// Whether the robot obeys by now. From then on the page is waited for.
bool Steersman::beginsToDrive(const Sensors& seen) {
  if (seen.cycle < port_.firstOfOurs() || seen.safety.state != darwinop::State::kDriven) return false;
  const std::scoped_lock lock{mutex_};
  if (!leaving_) report_.state = State::kDriving;
  heard_ = clock_.now();
  return true;
}

/// Throws std::runtime_error with the reason when the robot ends it.
void Steersman::driveUntilTheEnd() {
  Moves moves{*pages_};
  std::uint64_t cycle = port_.sensors().cycle;
  double ending_ms = 0, settle_ms = 0, taking_ms = 0;
  bool driving = false;
  while (const std::optional<Orders> orders = newest()) {
    const Sensors seen = port_.sensors();
    const double ms = static_cast<double>(static_cast<std::int64_t>(seen.cycle - cycle) * seen.period_ns) * 1e-6;
    cycle = seen.cycle;
    driving = driving || beginsToDrive(seen);
    if (!driving && (taking_ms += ms) > kLongestTaking)
      throw std::runtime_error("no torque came on. Is the servos' power switched on? The tab Faults says more");
    port_.obey(moves.turn(*orders, seen, ms));
    bool leaving = false;
    {
      const std::scoped_lock lock{mutex_};
      report_.doings = moves.doings();
      leaving = leaving_;
    }
    if (moves.doings().walks) settle_ms = kSettleMs;
    if (leaving && ((!moves.doings().walks && (settle_ms -= ms) <= 0) || (ending_ms += ms) > kLongestEndMs)) return;
    port_.waitForNextCycle();
    if (const std::string why = port_.mustEnd(); !why.empty()) throw std::runtime_error(why);
  }
}

}  // namespace darwinop::window
