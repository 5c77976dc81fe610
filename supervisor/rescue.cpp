// Brings the robot to rest after a runtime failure.
#include "supervisor/rescue.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "runtime/daemon.hpp"
#include "runtime/robot_notes.hpp"
#include "supervisor/holder.hpp"
#include "supervisor/journal.hpp"
#include "supervisor/messages.hpp"

namespace darwinop::supervisor {
namespace {

constexpr Nanos kFirstWait{100'000'000}, kLongestWait{1'000'000'000};
constexpr std::uint32_t kSession = 1;  // id of a session that ends with its first command

runtime::LoopConfig loopConfig(const RobotSettings& robot, const connect::OpenedBus& opened, bool held) {
  runtime::LoopConfig config;
  config.period = robot.serial.period;
  config.safety = opened.safety;
  // kStop would leave the robot as it was found; kRelease would drop it.
  config.safety.on_exit = safety::OnExit::kKneel;
  config.safety.held_before = held;
  config.port = opened.description;
  return config;
}

/// The previous port, or its new name. Another robot's adapter may have its number by now.
connect::OpenedBus openBus(const RobotSettings& robot, const runtime::RuntimeFiles& files) {
  const auto open = [&](const std::string& port) {
    connect::SerialRobot serial = robot.serial;
    serial.port = port;
    serial.before_servo_power = [&] { runtime::RobotNotes::noteServoPowerOff(files); };
    return connect::openSerialBus(serial, cm730::Purpose::kRescue);
  };
  auto error = std::make_exception_ptr(std::runtime_error(robot.serial.port + messages::kUnplugged));
  for (const std::string& port : cm730::portsOf(robot.serial.port, robot.identity)) {
    try {
      return open(port);
    } catch (const std::runtime_error&) {
      error = std::current_exception();
    }
  }
  std::rethrow_exception(error);
}

}  // namespace

/// Without runtime::DriverSession: it publishes two images and waits for no cycle, so a link would only add code.
class Rescue::OwnLoop {
 public:
  OwnLoop(const RobotSettings& robot, const runtime::RuntimeFiles& files, bool released)
      : OwnLoop{robot, files, released, runtime::claimRuntime(files, robot.group)} {}
  ~OwnLoop() { runtime::Exchange::remove(path_); }
  OwnLoop(const OwnLoop&) = delete;
  OwnLoop& operator=(const OwnLoop&) = delete;

  RescueWatch::Step update() {
    (void)exchange_.block().sensors.read(seen_);
    notes_.update(seen_);
    const RescueWatch::Step step = watch_.update(seen_);
    if (step == RescueWatch::Step::kCrouch && !session_ended_) endSession();
    return step;
  }
  [[nodiscard]] bool online() const { return watch_.online(); }
  [[nodiscard]] const Sensors& sensors() const { return seen_; }

 private:
  OwnLoop(const RobotSettings& robot, const runtime::RuntimeFiles& files, bool released, runtime::FileLock claim)
      : OwnLoop{robot, files, released, std::move(claim), openBus(robot, files)} {}

  OwnLoop(const RobotSettings& robot, const runtime::RuntimeFiles& files, bool released, runtime::FileLock claim,
          connect::OpenedBus opened)
      : path_{files.exchange},
        claim_{std::move(claim)},
        notes_{files},
        exchange_{closedExchange(path_, robot.group, released || notes_.released())},
        watch_{robot.serial.period, runtime::Rest::atMost(robot.serial.safety.gentle_speed)},
        host_{loopConfig(robot, opened, notes_.held()), std::move(opened.bus), exchange_,
              runtime::LoopStats::Timed::kYes, runtime::Recorder::Writer::kThread},
        driver_{host_.loop(), clock_, robot.serial.period, {}} {
    if (!notes_.warning().empty()) log(notes_.warning());
  }

  /// Red lights and no driver; no other process has access to the commands.
  static runtime::Exchange closedExchange(const std::string& path, gid_t group, bool released) {
    runtime::Exchange exchange = runtime::Exchange::createObservable(path, group);
    exchange.ownBlock().closing.store(runtime::ExchangeBlock::kNoControllers);
    exchange.ownBlock().released.store(released ? kSession : 0);
    Commands no_session;
    no_session.led = redLights();
    exchange.commands().commands.publish(no_session);
    return exchange;
  }

  /// The safety layer then acts as at the end of a session: see safety/guard_states.cpp, State::kFoundStiff.
  void endSession() {
    Commands last;
    last.led = redLights();
    last.session = kSession;
    last.sequence = 1;
    last.end_of_session = true;
    last.unattended = true;  // a release by a person during the rescue stays in force
    exchange_.commands().commands.publish(last);
    session_ended_ = true;
  }

  std::string path_;
  runtime::FileLock claim_;
  runtime::RobotNotes notes_;  // if this process is killed, the next supervisor reads them
  runtime::Exchange exchange_;
  RescueWatch watch_;
  Sensors seen_;
  bool session_ended_ = false;
  runtime::MonotonicClock clock_;
  runtime::LoopHost host_;
  runtime::PeriodicDriver driver_;  // last member: destroyed first
};

Rescue::Rescue(const RobotSettings& robot, const runtime::RuntimeFiles& files, bool released)
    : robot_{robot}, files_{files}, released_{released}, wait_{kFirstWait} {}

Rescue::~Rescue() = default;

Sensors Rescue::sensors() const {
  return loop_ ? loop_->sensors() : Sensors{};
}

bool Rescue::online() const {
  return loop_ && loop_->online();
}

void Rescue::open(Nanos now) {
  if (now < next_try_) return;
  next_try_ = now + wait_;
  wait_ = std::min(2 * wait_, kLongestWait);
  try {
    loop_ = std::make_unique<OwnLoop>(robot_, files_, released_);
    obstacle_.clear();
  } catch (const std::exception& error) {
    obstacle_ = error.what();
  }
}

Rescue::Step Rescue::update(Nanos now) {
  if (!loop_) open(now);
  if (!loop_) return Step::kOpening;
  switch (loop_->update()) {
    case RescueWatch::Step::kHold:
      return Step::kHold;
    case RescueWatch::Step::kCrouch:
      return Step::kCrouch;
    case RescueWatch::Step::kAtRest:
      return Step::kAtRest;
    case RescueWatch::Step::kStiff:
      return Step::kStiff;
  }
  return Step::kHold;
}

}  // namespace darwinop::supervisor
