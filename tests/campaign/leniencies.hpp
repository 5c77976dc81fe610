// What the judges of a campaign tolerate: one row for each place where they accept more than the promise says. They
// take their bounds from here, count how often each was needed, and docs/proven.md names each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace darwinop {

/// In the order of kLeniencyTable.
enum class Leniency : std::uint8_t {
  kNearJoint,
  kRecentPosition,
  kFirstGoal,
  kRounding,
  kGoalAfterLimit,
  kGoalInCable,
  kSecondSyncWrite,
  kUnseenRestart,
  kNoSpeedLimit,
  kLateWrite,
  kLateGoal,
  kUntrusted,
  kBlindTrip,
  kFirstTrip,
  kEarlyBit,
  kEarlyTrips,
  kStillStiff,
  kShortPress,
  kRecovery,
  kReadingSlack,
  kWrongReadings,
  kTwinReadings,
  kCount
};
inline constexpr std::size_t kLeniencies = static_cast<std::size_t>(Leniency::kCount);

struct LeniencyRow {
  Leniency leniency;
  std::string_view name;
  double bound;
  std::string_view unit;
  std::string_view why;
};

inline constexpr auto kLeniencyTable = std::to_array<LeniencyRow>({
    {Leniency::kNearJoint, "goal beside the joint", 9, "ticks", "two readings agree within 8.5 ticks"},
    {Leniency::kRecentPosition, "goal where the joint was", 8, "cycles", "the joint moves on while goals are placed"},
    {Leniency::kFirstGoal, "first goal on the wire", 65, "ticks", "0.1 rad: a joint that swings after its reading"},
    {Leniency::kRounding, "longer step", 1, "tick", "angles are rounded to ticks"},
    {Leniency::kGoalAfterLimit, "step after a limit that was sent alone", 1, "step", "the goal waited for a cycle"},
    {Leniency::kGoalInCable, "step after a goal lost in a cable", 1, "step", "the PC cannot see the loss"},
    {Leniency::kSecondSyncWrite, "second SyncWrite", 0.8, "of the torque limit",
     "a servo that works at its limit must not get limit and goal together"},
    {Leniency::kUnseenRestart, "restart without a missed answer", 6, "cycles", "the next poll finds it"},
    {Leniency::kNoSpeedLimit, "torque without a speed limit", 64, "cycles", "until each servo has been polled"},
    {Leniency::kLateWrite, "write executed at once", 2, "cycles", "a later one was held by a stalled board"},
    {Leniency::kLateGoal, "late goal", 1, "before an answer", "a sent frame cannot be revoked"},
    {Leniency::kUntrusted, "after a damaged write or a duplicate id", 80, "cycles",
     "8-bit checksums let one damaged frame in 256 pass"},
    {Leniency::kBlindTrip, "shutdown beside a new torque limit", 1, "cycle", "the write left before any answer"},
    {Leniency::kFirstTrip, "shutdown before it is believed", 1, "shutdown", "one bit may be damaged"},
    {Leniency::kEarlyBit, "overload bit after torque on", 20, "cycles", "the bit of the last shutdown fades"},
    {Leniency::kEarlyTrips, "shutdowns in takeovers", 20, "in a row", "the joint is placed again each time"},
    {Leniency::kStillStiff, "torque in a limp robot", 80, "cycles", "a lost torque off is repeated after a poll"},
    {Leniency::kShortPress, "MODE pressed without effect", 17, "cycles", "0.25 s, against contact noise"},
    {Leniency::kRecovery, "time until driven again", 500, "cycles", "boot, gentle way to the start pose and back"},
    {Leniency::kReadingSlack, "reading beside the joint", 4, "ticks", "quantization"},
    {Leniency::kWrongReadings, "wrong readings on a line that damages bytes", 1e-5, "of all", "8-bit checksums"},
    {Leniency::kTwinReadings, "wrong readings of a duplicate id", 1, "of all", "no reader can detect the mixture"},
});

constexpr bool leniencyRowsAreInOrder() {
  for (std::size_t i = 0; i < kLeniencyTable.size(); ++i)
    if (static_cast<std::size_t>(kLeniencyTable[i].leniency) != i) return false;
  return kLeniencyTable.size() == kLeniencies;
}
static_assert(leniencyRowsAreInOrder());

constexpr double bound(Leniency leniency) {
  return kLeniencyTable[static_cast<std::size_t>(leniency)].bound;
}
/// For bounds that are counts.
template <class Number>
constexpr Number boundAs(Leniency leniency) {
  return static_cast<Number>(bound(leniency));
}

/// How often each was needed.
class Tolerated {
 public:
  void note(Leniency leniency, long times = 1) { count_[static_cast<std::size_t>(leniency)] += times; }
  [[nodiscard]] long of(Leniency leniency) const { return count_[static_cast<std::size_t>(leniency)]; }
  Tolerated& operator+=(const Tolerated& other) {
    for (std::size_t i = 0; i < kLeniencies; ++i) count_[i] += other.count_[i];
    return *this;
  }

 private:
  std::array<long, kLeniencies> count_{};
};

/// "goal beside the joint (9 ticks)", as docs/proven.md has it.
[[nodiscard]] std::string nameOf(const LeniencyRow& row);
/// A line for each row: count, name, bound and reason.
[[nodiscard]] std::string report(const Tolerated& tolerated);

}  // namespace darwinop
