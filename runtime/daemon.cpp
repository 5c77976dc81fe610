// The loop in a process of its own.
#include "runtime/daemon.hpp"

#include <time.h>
#include <unistd.h>

#include <stdexcept>

namespace darwinop::runtime {
namespace {

/// A signal ends it early.
void doze() {
  const timespec pause{0, 50'000'000};
  nanosleep(&pause, nullptr);
}

}  // namespace

FileLock claimRuntime(const RuntimeFiles& files, gid_t group) {
  if (auto claim = FileLock::tryTake(files.loop_lock, group)) return std::move(*claim);
  const std::string pid = std::to_string(FileLock::holder(files.loop_lock));
  throw std::runtime_error("a runtime with this name runs already (pid " + pid + "); end it with: kill " + pid +
                           "  or start this one under another name with --name");
}

Daemon::Daemon(const LoopConfig& config, const RuntimeFiles& files, FileLock claim, gid_t group,
               std::unique_ptr<ServoBus> bus)
    : files_{files},
      claim_{std::move(claim)},
      exchange_{Exchange::create(files.exchange, group)},
      rest_{config.safety.on_exit},
      host_{config, std::move(bus), exchange_.block(), LoopStats::Timed::kYes, Recorder::Writer::kThread},
      driver_{host_.loop(), clock_, config.period, config.real_time} {}

Daemon::~Daemon() {
  unlink(files_.exchange.c_str());
}

void Daemon::run(const std::atomic<bool>& stop) {
  while (!stop.load()) doze();
  exchange_.block().closing.store(1);  // ends the controller, and brings the robot to rest
  const std::uint64_t first = sensors().cycle;
  const Nanos give_up = clock_.now() + Rest::kAtMost;
  for (Sensors seen = sensors(); !rest_.reached(seen.cycle - first, seen) && clock_.now() < give_up; seen = sensors())
    doze();
}

Sensors Daemon::sensors() const {
  Sensors sensors;
  (void)exchange_.block().sensors.read(sensors);
  return sensors;
}

}  // namespace darwinop::runtime
