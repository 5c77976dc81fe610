#include "hal/cm730/diagnosis/line_events.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace darwinop::cm730 {
namespace {

constexpr std::size_t kChains = 5;
// Request and reply of a read of two registers, and of registers 0..43.
constexpr double kShortReadBytes = 8 + 8, kLongReadBytes = 8 + 50;
// Others measure 0.2 to 0.4 % lost short reads, or 1 to 3 lost replies in 10 000 bytes.
constexpr double kNoisyPerByte = 5e-4;
constexpr int kNoisyLosses = 5;

constexpr int kLooseEvents = 5;
constexpr double kLooseShare = 0.8;    // of all events, in its chain
constexpr double kLooseRate = 0.05;    // lost replies of the servos behind it
constexpr double kBehindShare = 0.25;  // of the events of the worst servo in the chain

int lossesOf(const ServoFacts& servo) {
  return servo.losses + servo.long_losses;
}
int eventsOf(const ServoFacts& servo) {
  return lossesOf(servo) + servo.late_answers + (servo.restarted ? 1 : 0);
}

struct ChainEvents {
  int events = 0, worst = 0;
  void add(const ServoFacts& servo) {
    events += eventsOf(servo);
    worst = std::max(worst, eventsOf(servo));
  }
};

double byteCount(const RobotFacts& facts) {
  double bytes = 0;
  for (const ServoFacts& servo : facts.servo)
    bytes += servo.reads * kShortReadBytes + servo.long_reads * kLongReadBytes;
  return bytes;
}

}  // namespace

std::optional<LooseConnector> findLooseConnector(const RobotFacts& facts) {
  std::array<ChainEvents, kChains> chains{};
  int all = 0;
  for (std::size_t i = 0; i < kJoints; ++i) {
    chains[static_cast<std::size_t>(kJointTable[i].chain)].add(facts.servo[i]);
    all += eventsOf(facts.servo[i]);
  }
  const auto worst = std::ranges::max_element(chains, {}, &ChainEvents::events);
  if (worst->events < kLooseEvents || worst->events < kLooseShare * all) return std::nullopt;
  const auto chain = static_cast<Chain>(worst - chains.begin());

  LooseConnector loose;
  std::optional<Joint> previous;
  int reads = 0, losses = 0, late = 0;
  bool behind = false;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const ServoFacts& servo = facts.servo[i];
    if (kJointTable[i].chain != chain || servo.absent) continue;
    if (!behind && eventsOf(servo) >= kBehindShare * worst->worst) {
      behind = true;
      loose.first = static_cast<Joint>(i);
      loose.from = previous;
    }
    previous = static_cast<Joint>(i);
    if (!behind) continue;
    reads += servo.reads + servo.long_reads;
    losses += lossesOf(servo);
    late += servo.late_answers + (servo.restarted ? 1 : 0);
  }
  if (late == 0 && losses < kLooseRate * reads) return std::nullopt;
  loose.evidence = std::to_string(losses) + " of " + std::to_string(reads) + " replies from there on were lost, and " +
                   std::to_string(all - worst->events) + " in the other chains";
  return loose;
}

int lostReplies(const RobotFacts& facts) {
  int losses = 0;
  for (const ServoFacts& servo : facts.servo) losses += lossesOf(servo);
  return losses;
}

bool isNoisy(const RobotFacts& facts) {
  const int losses = lostReplies(facts);
  return losses >= kNoisyLosses && losses >= kNoisyPerByte * byteCount(facts);
}

std::string noiseText(const RobotFacts& facts) {
  char text[100];
  std::snprintf(text, sizeof text, "%d replies were lost in %.0f bytes", lostReplies(facts), byteCount(facts));
  return text;
}

bool acrossChains(const RobotFacts& facts) {
  std::array<bool, kChains> restarted{};
  for (std::size_t i = 0; i < kJoints; ++i)
    if (facts.servo[i].restarted) restarted[static_cast<std::size_t>(kJointTable[i].chain)] = true;
  return std::ranges::count(restarted, true) > 1;
}

}  // namespace darwinop::cm730
