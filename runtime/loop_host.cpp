// Builds a loop from its parts.
#include "runtime/loop_host.hpp"

#include <unistd.h>

#include <stdexcept>

#include "safety/session_settings.hpp"

namespace darwinop::runtime {
namespace {

safety::Config withPeriod(safety::Config safety, Nanos period) {
  safety.period = period;
  return safety;
}

std::unique_ptr<Recorder> makeRecorder(const LoopConfig& config, Recorder::Writer writer) {
  if (config.record_path.empty()) return nullptr;
  const LogHead head{config.robot, config.port, config.period, config.record_notes};
  return std::make_unique<Recorder>(config.record_path, head, writer);
}

}  // namespace

const LoopConfig& checked(const LoopConfig& config) {
  using namespace std::chrono_literals;
  if (config.period < 1ms || config.period > 1s)
    throw std::runtime_error(
        "a period of " + std::to_string(config.period.count() / 1'000) +
        " us is not possible; choose 1 to 1000 ms in simulation, 8 to 50 on a robot (16 is usual)");
  return config;
}

LoopInfo describe(const LoopConfig& config) {
  LoopInfo info;
  info.period_ns = config.period.count();
  info.pid = getpid();
  setText(info.robot, sizeof info.robot, config.robot);
  setText(info.port, sizeof info.port, config.port);
  info.safety = safety::toSession(config.safety);
  info.safety_named = static_cast<std::uint32_t>(config.safety.named.to_ulong());
  return info;
}

LoopHost::LoopHost(const LoopConfig& config, std::unique_ptr<ServoBus> bus, const Exchange& exchange,
                   LoopStats::Timed timed, Recorder::Writer writer)
    : bus_{std::move(bus)},
      guard_{withPeriod(checked(config).safety, config.period)},
      recorder_{makeRecorder(config, writer)},
      loop_{*bus_, guard_, exchange, recorder_.get(), config.period, timed} {
  exchange.ownBlock().info = describe(config);
}

}  // namespace darwinop::runtime
