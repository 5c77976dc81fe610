#include "runtime/command_observer.hpp"

#include <sys/mman.h>

#include <exception>
#include <limits>

#include "core/servo_limits.hpp"
#include "runtime/exchange_files.hpp"

namespace darwinop::runtime {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::unique_ptr<CommandObserver> CommandObserver::attach(const std::string& exchange, const ExchangeBlock& block) {
  try {
    const Descriptor output = openedBlock(exchange);
    const Descriptor input = openedCommands(commandsPath(exchange), userOf(output));
    if (!hasSize(input, sizeof(CommandBlock))) return nullptr;
    std::unique_ptr<CommandObserver> made{
        new CommandObserver{mapped(input, exchange, sizeof(CommandBlock), PROT_READ)}};
    return made->block().instance == block.instance ? std::move(made) : nullptr;
  } catch (const std::exception&) {
    return nullptr;
  }
}

std::array<double, kJoints> CommandObserver::pGains() const {
  std::array<double, kJoints> out;
  out.fill(kDefaultPGain);
  Commands asked;
  if (!block().commands.read(asked)) return out;
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!asked.joint[i].has(JointCommand::kPGain)) continue;
    const double gain = asked.joint[i].p_gain;
    out[i] = gain >= 0 && gain <= kMaxPGain ? gain : kNone;
  }
  return out;
}

}  // namespace darwinop::runtime
