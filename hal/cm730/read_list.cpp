#include "hal/cm730/read_list.hpp"

#include <algorithm>

namespace darwinop::cm730 {
namespace {

// A miss can be noise; three in a row at the end of the list, where nobody stands before it, is a silent servo.
constexpr std::uint8_t kMissesUntilSilent = 3;
// After a miss a servo stays at the end until it has answered this often: a loose cable comes back in bursts.
constexpr std::uint16_t kTrialCycles = 64;
// All silent servos together are asked once in this many cycles: 0.77 s at 16 ms.
constexpr std::uint32_t kProbeRound = 48;
constexpr std::uint32_t kSlowestProbe = 16;  // cycles; waiting for nobody costs the link's margin each time
// An MX-28 answers about 0.2 s after its supply comes; the vendor's framework waits 0.3 s.
constexpr Nanos kBootTime{300'000'000};

}  // namespace

ReadList::ReadList(Nanos period, std::size_t looks, const Mask& absent)
    : looks_{looks}, absent_{absent}, boot_cycles_{static_cast<std::uint32_t>(kBootTime / period) + 1} {}

std::span<const ReadList::Entry> ReadList::next() noexcept {
  length_ = 0;
  if (boot_wait_ > 0) return {};
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    if (!silent_[joint] && on_trial_[joint] == 0 && !suspects_[joint]) append(joint);
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    if (!silent_[joint] && (on_trial_[joint] > 0 || suspects_[joint]) && misses_[joint] == 0) append(joint);
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    if (!silent_[joint] && misses_[joint] > 0) append(joint);
  lookInTurn();
  appendProbe();
  chooseLooks();
  return {list_.data(), length_};
}

void ReadList::append(std::size_t joint) noexcept {
  if (absent_[joint]) return;
  list_[length_++] = {static_cast<std::uint8_t>(joint), false};
  if (misses_[joint] > 0) ++retries_;
}

void ReadList::chooseLooks() noexcept {
  std::size_t left = looks_;
  for (std::size_t i = 0; i < length_ && left > 0; ++i) {
    if (!due_[list_[i].joint] || list_[i].look) continue;
    list_[i].look = true;
    --left;
  }
}

void ReadList::lookInTurn() noexcept {
  if (length_ == 0) return;
  // The next joint in turn that is in the list; a silent one loses its turn.
  for (std::size_t step = 0; step < kJoints; ++step) {
    const std::size_t joint = (next_look_ + step) % kJoints;
    for (std::size_t i = 0; i < length_; ++i) {
      if (list_[i].joint != joint) continue;
      list_[i].look = true;
      next_look_ = (joint + 1) % kJoints;
      return;
    }
  }
}

void ReadList::appendProbe() noexcept {
  if (silent_.none()) return;
  if (cycles_to_probe_ > 0 && !probe_answered_) {
    --cycles_to_probe_;
    return;
  }
  while (!silent_[next_probe_]) next_probe_ = (next_probe_ + 1) % kJoints;
  list_[length_++] = {static_cast<std::uint8_t>(next_probe_), false};
  ++retries_;
  next_probe_ = (next_probe_ + 1) % kJoints;
  const auto interval = std::clamp(kProbeRound / static_cast<std::uint32_t>(silent_.count()), 1U, kSlowestProbe);
  cycles_to_probe_ = interval - 1;
  probe_answered_ = false;
}

void ReadList::answered(const Mask& who) noexcept {
  std::size_t last_answer = 0;  // one past the last entry that answered
  due_ |= ~who;
  for (std::size_t i = 0; i < length_; ++i) {
    const std::size_t joint = list_[i].joint;
    if (!who[joint]) continue;
    last_answer = i + 1;
    if (list_[i].look) due_.reset(joint);
    forgive(joint);
  }
  // Whoever is missing before the last answer was heard by its neighbour: only its frame was damaged. Behind
  // the last answer the first one is to blame; of those behind it nothing is known.
  if (last_answer == length_) return;
  blame(list_[last_answer].joint);
  // A plug that comes off silences the rest of its chain, too: those are asked behind the others until they answer.
  const Chain chain = kJointTable[list_[last_answer].joint].chain;
  for (std::size_t i = last_answer + 1; i < length_; ++i)
    if (kJointTable[list_[i].joint].chain == chain) suspects_.set(list_[i].joint);
}

void ReadList::forgive(std::size_t joint) noexcept {
  misses_[joint] = 0;
  suspects_.reset(joint);
  if (silent_[joint]) {
    silent_.reset(joint);
    on_trial_[joint] = kTrialCycles;
    probe_answered_ = true;  // what woke this one may have woken others: ask the next one at once
  } else if (on_trial_[joint] > 0) {
    --on_trial_[joint];
  }
}

void ReadList::blame(std::size_t joint) noexcept {
  on_trial_[joint] = kTrialCycles;
  if (silent_[joint]) return;
  if (++misses_[joint] < kMissesUntilSilent) return;
  silent_.set(joint);
  misses_[joint] = 0;
  if (silent_.count() == 1) cycles_to_probe_ = kSlowestProbe;
}

void ReadList::powerIsOff() noexcept {
  powered_ = false;
  boot_wait_ = boot_cycles_;
  silent_.reset();
  suspects_.reset();
  misses_.fill(0);
  on_trial_.fill(0);
}

void ReadList::powerIsOn() noexcept {
  powered_ = true;
  if (boot_wait_ > 0) --boot_wait_;
}

}  // namespace darwinop::cm730
