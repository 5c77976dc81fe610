// Start, duration and end of faults.
#include "hil-mocks/fault_injector.hpp"

#include <algorithm>
#include <utility>

#include "core/units.hpp"
#include "hil-mocks/random_fault.hpp"
#include "hil-mocks/wire_faults.hpp"

namespace darwinop::hil {
namespace {

constexpr Nanos kRampStep = std::chrono::milliseconds{100};

/// From `normal` to the fault's amount, linearly over `over`.
double ramped(const InjectedFault& fault, double normal, Nanos now) {
  const Nanos gone = now - fault.at;
  if (gone >= fault.over) return fault.amount;
  return normal + (fault.amount - normal) * static_cast<double>(gone.count()) / static_cast<double>(fault.over.count());
}

/// Accelerometer of a robot that lies. Face down the y axis points up (firmware: y < 512 - 80).
std::array<double, 3> lying(Fall fall) {
  switch (fall) {
    case Fall::kFront:
      return {0, -kGravity, 0};
    case Fall::kBack:
      return {0, kGravity, 0};
    case Fall::kLeft:
      return {-kGravity, 0, 0};
    case Fall::kRight:
      return {kGravity, 0, 0};
  }
  return {0, 0, kGravity};
}

/// With `chance`, only some status packets carry the error bits.
bool flickers(const InjectedFault& fault) {
  return fault.kind == FaultKind::kErrors && fault.chance < 1;
}

}  // namespace

FaultInjector::FaultInjector(std::uint64_t seed) : seed_{seed}, random_{seed} {
  waiting_.reserve(kRoom);
  active_.reserve(kRoom);
}

void FaultInjector::add(const InjectedFault& fault) {
  const auto place = std::ranges::lower_bound(waiting_, fault.at, std::ranges::greater{}, &InjectedFault::at);
  waiting_.insert(place, fault);
  next_change_ = std::min(next_change_, fault.at);
}

void FaultInjector::add(std::span<const InjectedFault> faults) {
  const auto earliest_first = [this] { std::ranges::reverse(waiting_); };  // used twice, to restore the order
  earliest_first();
  waiting_.insert(waiting_.end(), faults.begin(), faults.end());
  std::ranges::stable_sort(waiting_, {}, &InjectedFault::at);
  earliest_first();
  if (!waiting_.empty()) next_change_ = std::min(next_change_, waiting_.back().at);
}

void FaultInjector::clear() noexcept {
  waiting_.clear();
  active_.clear();
  wire_faults_ = false;
  cleared_ = true;
  next_change_ = Nanos{0};  // the effects are undone at once
}

void FaultInjector::apply(Nanos now, VirtualBoard& board) noexcept {
  if (std::exchange(cleared_, false)) board.forgetMisses();
  std::erase_if(active_, [now](const Active& a) {
    return a.fault.end() <= now && !(isWireFault(a.fault.kind) && a.fault.lasts == Nanos{0});
  });
  for (std::size_t i = 0; i < active_.size(); ++i)
    if (active_[i].fault.kind == FaultKind::kRandom) draw(active_[i], now);
  while (!waiting_.empty() && waiting_.back().at <= now) {
    begin(waiting_.back(), board);
    waiting_.pop_back();
  }
  for (Active& a : active_)
    if (a.fault.kind == FaultKind::kBabble) babble(a, now, board);
  wire_faults_ =
      std::ranges::any_of(active_, [](const Active& a) { return isWireFault(a.fault.kind) || flickers(a.fault); });
  showEffects(now, board);
  planNext(now);
}

void FaultInjector::begin(const InjectedFault& fault, VirtualBoard& board) noexcept {
  ++begun_;
  ++begun_of_[static_cast<std::size_t>(fault.kind)];
  if (fault.kind == FaultKind::kReset) return board.pressReset();
  if (fault.kind == FaultKind::kMiss) return board.missBulkReads(static_cast<int>(fault.amount));
  for (std::size_t i = 0; i < kJoints; ++i)
    if (fault.joints[i] && fault.boot) board.setBoot(static_cast<Joint>(i), *fault.boot);
  active_.push_back({fault, fault.at});
  if (fault.kind == FaultKind::kRandom)
    active_.back().next_draw = fault.at + faultTime(random_.between(0, 2 / fault.amount));
}

void FaultInjector::babble(Active& source, Nanos now, VirtualBoard& board) noexcept {
  if (source.next_draw > now) return;
  std::array<std::uint8_t, 64> bytes;
  const std::size_t count = std::min(bytes.size(), 1 + random_.below(static_cast<std::size_t>(source.fault.amount)));
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(random_.below(256));
  board.babble(Bytes{bytes}.first(count));
  source.next_draw = now + faultTime(random_.between(0.0005, 0.02));
}

void FaultInjector::draw(Active& source, Nanos now) noexcept {
  if (source.fault.amount <= 0) return;
  while (source.next_draw <= now) {
    FaultKinds kinds = source.fault.kinds;
    kinds.reset(static_cast<std::size_t>(FaultKind::kRandom));
    if (kinds.any() && waiting_.size() < waiting_.capacity() && active_.size() < kRoom / 2) {
      std::size_t kind = random_.below(kFaultKinds);
      while (!kinds[kind]) kind = (kind + 1) % kFaultKinds;
      add(randomFault(static_cast<FaultKind>(kind), source.next_draw, random_));
    }
    source.next_draw += faultTime(random_.between(0, 2 / source.fault.amount)) + Nanos{1};
  }
}

void FaultInjector::showEffects(Nanos now, VirtualBoard& board) noexcept {
  const BoardOptions& normal = board.options();
  std::bitset<kJoints> dead;
  std::array<std::uint8_t, kJoints> errors{};
  std::array<std::optional<double>, kJoints> celsius;  // empty: from the body
  std::array<std::optional<Nanos>, kJoints> jam;
  std::bitset<kJoints> twins;
  std::array<double, kJoints> noise{};
  double supply_v = normal.supply_v, sag_v = 0;
  std::uint8_t buttons = 0;
  std::optional<std::array<double, 3>> acceleration;
  Nanos stalled_until{0};
  unplugged_ = false;

  for (const auto& [fault, next_draw] : active_) {
    for (std::size_t i = 0; i < kJoints; ++i) {
      if (!fault.joints[i]) continue;
      if (fault.kind == FaultKind::kJam) jam[i] = faultTime(fault.amount);
      if (fault.kind == FaultKind::kNoise) noise[i] = std::max(noise[i], fault.chance);
      if (fault.kind == FaultKind::kErrors && !flickers(fault)) errors[i] |= fault.bits;
      if (fault.kind == FaultKind::kHeat)  // of two the hotter one: a servo does not cool when another one begins
        celsius[i] = std::max(celsius[i], std::optional{ramped(fault, normal.temperature_c, now)});
    }
    if (fault.kind == FaultKind::kDead) dead |= fault.joints;
    if (fault.kind == FaultKind::kVoltage) supply_v = ramped(fault, normal.supply_v, now);
    if (fault.kind == FaultKind::kTwins) twins |= fault.joints;
    if (fault.kind == FaultKind::kSag) sag_v = std::max(sag_v, fault.amount);
    if (fault.kind == FaultKind::kButton) buttons |= fault.bits;
    if (fault.kind == FaultKind::kFallen) acceleration = lying(fault.fall);
    if (fault.kind == FaultKind::kStall) stalled_until = std::max(stalled_until, fault.end());
    if (fault.kind == FaultKind::kUnplug) unplugged_ = true;
  }

  board.stallUntil(stalled_until);
  board.setSupply(supply_v);
  board.setSag(sag_v);
  board.setButtons(buttons);
  board.setAcceleration(acceleration);
  for (std::size_t i = 0; i < kJoints; ++i) {
    const Joint joint = static_cast<Joint>(i);
    board.setServoErrors(joint, errors[i]);
    board.setTemperature(joint, celsius[i]);
    board.setJam(joint, jam[i]);
    board.setTwin(joint, twins[i]);
    board.setNoise(joint, noise[i]);
    if (dead[i] == dead_[i]) continue;
    board.setServoDead(joint, dead[i]);
    if (!dead[i]) board.setBoot(joint, normal.servo_boot);  // that of the fault was for this start
  }
  dead_ = dead;
}

void FaultInjector::planNext(Nanos now) noexcept {
  next_change_ = waiting_.empty() ? Nanos::max() : waiting_.back().at;
  for (const auto& [fault, next_draw] : active_) {
    if (fault.end() > now) next_change_ = std::min(next_change_, fault.end());
    const Nanos reached = fault.at + fault.over;
    if (now < reached) next_change_ = std::min({next_change_, reached, now + kRampStep});
    if (fault.kind == FaultKind::kRandom || fault.kind == FaultKind::kBabble)
      next_change_ = std::min(next_change_, next_draw);
  }
}

void FaultInjector::pass(Chunk& chunk, Way way) noexcept {
  if (!wire_faults_) return;
  std::erase_if(active_, [&](const Active& a) {
    const InjectedFault& fault = a.fault;
    if (flickers(fault)) {
      if (way == Way::kReplies) flicker(chunk, fault, random_);
      return false;
    }
    const bool same_way = (static_cast<int>(fault.way) & static_cast<int>(way)) != 0;
    if (!isWireFault(fault.kind) || !same_way || random_.uniform() >= fault.chance) return false;
    spoil(chunk, fault, random_);
    return fault.lasts == Nanos{0};
  });
}

}  // namespace darwinop::hil
