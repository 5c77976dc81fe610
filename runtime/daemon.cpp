// The daemon: hosts the loop in its own process.
#include "runtime/daemon.hpp"

#include <time.h>

#include <iostream>
#include <stdexcept>

#include "runtime/fault_announcer.hpp"
#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

/// A signal ends it early.
void doze() {
  const timespec pause{0, 50'000'000};
  nanosleep(&pause, nullptr);
}

RobotNotes ownNotes(const RuntimeFiles& files) {
  RobotNotes notes{files};
  if (!notes.warning().empty()) std::cerr << "darwinop runtime: " << notes.warning() << std::endl;
  if (!notes.kept())
    throw std::runtime_error(messages::kNoMarkers + files.released + " and " + files.held +
                             ": another user has the name, or the folder cannot be written");
  return notes;
}

/// A robot that was released under an earlier daemon stays released until a session begins, which may be before the
/// first cycle.
Exchange createExchange(const LoopConfig& config, const RuntimeFiles& files, gid_t group, bool released) {
  return Exchange::create(files.exchange, group, [&](ExchangeBlock& block) {
    block.info = describe(config);
    block.session.store(released ? 1 : 0);
    block.released.store(released ? 1 : 0);
  });
}

LoopConfig afterAnother(LoopConfig config, const RobotNotes& notes) {
  config.safety.held_before = notes.held();
  return config;
}

}  // namespace

FileLock claimRuntime(const RuntimeFiles& files, gid_t group) {
  if (auto claim = FileLock::tryTake(files.loop_lock, group)) {
    // Created here, so that it belongs to the group and not to the first controller's user.
    (void)FileLock::tryTake(files.drive_lock, group);
    return std::move(*claim);
  }
  const pid_t holder = FileLock::holder(files.loop_lock);
  if (holder <= 0) throw std::runtime_error("another runtime with this name starts or ends just now; try again");
  const std::string pid = std::to_string(holder);
  throw std::runtime_error("a runtime with this name runs already (pid " + pid + "); end it with: kill " + pid +
                           "  or start this one under another name with --name");
}

Daemon::Daemon(const LoopConfig& config, const RuntimeFiles& files, FileLock claim, gid_t group,
               std::unique_ptr<ServoBus> bus)
    : files_{files},
      claim_{std::move(claim)},
      notes_{ownNotes(files)},
      exchange_{createExchange(checked(config), files, group, notes_.released())},
      rest_{config.safety, config.period},
      host_{afterAnother(config, notes_), std::move(bus), exchange_, LoopStats::Timed::kYes, Recorder::Writer::kThread},
      driver_{host_.loop(), clock_, config.period, config.real_time} {}

Daemon::~Daemon() {
  notes_.tidy();
  Exchange::remove(files_.exchange);
}

JointSet Daemon::run(const std::atomic<bool>& stop) {
  FaultAnnouncer announcer{std::cerr};
  for (; !stop.load() && !exchange_.shortened(); doze()) {
    const Sensors seen = sensors();
    announcer.update(seen);
    notes_.update(seen);
  }
  letControllerEnd();
  exchange_.ownBlock().closing.store(ExchangeBlock::kClosing);  // ends the controller and brings the robot to rest
  const Nanos give_up = clock_.now() + rest_.atMost(sensors());
  for (Sensors seen = sensors(); !rest_.reached(seen) && clock_.now() < give_up; seen = sensors()) {
    announcer.update(seen);
    notes_.update(seen);
    doze();
  }
  const Sensors last = sensors();
  notes_.update(last);
  if (exchange_.shortened())
    throw std::runtime_error("the shared memory (" + files_.exchange +
                             ") was shortened or overwritten by another program, so the robot was brought to rest; "
                             "start the runtime again");
  // A board that became silent when all servos had been seen limp leaves nothing unknown.
  if (last.safety.state == State::kOffline && !notes_.held()) return {};
  const JointSet present = everAnswered(last);
  return perhapsUnderTorque(last, present.none() ? ~present : present);
}

/// Until the controller ends its session, or is silent for stall_ms.
void Daemon::letControllerEnd() {
  constexpr Nanos kPatience{3'000'000'000};  // a walk finishes its steps within 2.9 s
  exchange_.ownBlock().closing.store(ExchangeBlock::kEnding);
  const Nanos give_up = clock_.now() + kPatience;
  while (!exchange_.shortened() && sensors().safety.state == State::kDriven && clock_.now() < give_up) doze();
}

Sensors Daemon::sensors() const {
  Sensors sensors;
  (void)exchange_.block().sensors.read(sensors);
  return sensors;
}

}  // namespace darwinop::runtime
