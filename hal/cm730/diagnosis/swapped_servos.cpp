#include "hal/cm730/diagnosis/swapped_servos.hpp"

#include <bitset>
#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::cm730 {
namespace {

constexpr double kNearStart = 0.15;  // rad; the tolerance of a start move
constexpr double kBeyondStop = 0.1;  // rad; a joint pressed against its stop
constexpr std::size_t kFewest = 16;  // servos that must be where they belong

double angleAt(int ticks) {
  return radFromTicks(ticks).value;
}

/// The joints for which `fits(own index, angle)` is false, if they are two and `fits` for each other's place.
template <class Fits>
std::optional<SwappedPair> exchanged(const RobotFacts& facts, Fits&& fits) {
  std::bitset<kJoints> elsewhere;
  std::size_t in_place = 0;
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!facts.servo[i].readable) continue;
    if (fits(i, facts.servo[i].position.value))
      ++in_place;
    else
      elsewhere.set(i);
  }
  if (elsewhere.count() != 2 || in_place < kFewest) return std::nullopt;
  SwappedPair pair;
  std::size_t found[2]{}, count = 0;
  forEachJoint(elsewhere, [&](std::size_t i) { found[count++] = i; });
  const auto [a, b] = found;
  if (!fits(b, facts.servo[a].position.value) || !fits(a, facts.servo[b].position.value)) return std::nullopt;
  pair.first = static_cast<Joint>(a);
  pair.second = static_cast<Joint>(b);
  return pair;
}

}  // namespace

std::optional<SwappedPair> findSwapped(const RobotFacts& facts) {
  auto pair = exchanged(
      facts, [](std::size_t i, double angle) { return std::abs(angle - angleAt(kJointTable[i].start)) <= kNearStart; });
  if (pair) {
    pair->evidence = "all other joints are in the start pose, and each of these is in the other's";
    return pair;
  }
  pair = exchanged(facts, [](std::size_t i, double angle) {
    return angle >= angleAt(kJointTable[i].low) - kBeyondStop && angle <= angleAt(kJointTable[i].high) + kBeyondStop;
  });
  if (pair) pair->evidence = "each is at an angle that only the other's joint can reach";
  return pair;
}

}  // namespace darwinop::cm730
