#include "hal/cm730/read_list.hpp"

#include <algorithm>

namespace darwinop::cm730 {
namespace {

// One miss can be noise. Three in a row at the end of the list, where no other servo is the cause, mean a silent servo.
constexpr std::uint8_t kMissesUntilSilent = 3;
// Replies until a servo leaves the end of the list after a miss: a loose cable makes contact in bursts.
constexpr std::uint16_t kTrialCycles = 64;
// Cycles in which all silent servos are retried once: 0.77 s at 16 ms.
constexpr std::uint32_t kProbeRound = 48;
constexpr std::uint32_t kSlowestProbe = 16;  // cycles; each missing reply costs the link's margin
// An MX-28 replies about 0.2 s after power-up; the vendor's framework waits 0.3 s.
constexpr Nanos kBootTime{300'000'000};

}  // namespace

ReadList::ReadList(Nanos period, std::size_t polls, const Mask& absent, bool board)
    : polls_{polls}, board_{board}, absent_{absent}, boot_cycles_{static_cast<std::uint32_t>(kBootTime / period) + 1} {}

std::span<const ReadList::Entry> ReadList::next() noexcept {
  length_ = 0;
  listed_.reset();
  polled_.reset();
  if (boot_wait_ > 0) return {};
  const Mask asked = ~silent_ & ~absent_, doubtful = tried_ | suspected_, again = asked & missed_;
  append(asked & ~doubtful);
  append(asked & doubtful & ~missed_);
  append(again);
  retries_ += static_cast<std::uint32_t>(again.count());
  if (!board_) placeLeader();
  pollInTurn();
  appendProbe();
  choosePolls();
  return {list_.data(), length_};
}

std::span<const ReadList::Entry> ReadList::nextAlone() noexcept {
  next();
  length_ = std::min(length_, std::size_t{1});
  listed_.reset();
  if (length_ > 0) listed_.set(list_[0].joint);
  polled_ = listed_;
  return {list_.data(), length_};
}

void ReadList::placeLeader() noexcept {
  if (length_ == 0) return;
  const auto end = list_.begin() + static_cast<std::ptrdiff_t>(length_);
  if (passed_.any()) {
    const auto chainPassed = [this](const Entry& entry) {
      return jointsThat(passed_, [&](std::size_t i) { return kJointTable[i].chain == kJointTable[entry.joint].chain; })
          .any();
    };
    auto leader = std::find_if_not(list_.begin(), end, chainPassed);
    if (leader == end) leader = std::find_if(list_.begin(), end, [this](const Entry& e) { return !passed_[e.joint]; });
    if (leader == end) {
      passed_.reset();
      leader = list_.begin();
    }
    std::rotate(list_.begin(), leader, std::next(leader));
  }
  list_[0].poll = true;
  polled_.set(list_[0].joint);
}

void ReadList::leaderMissed() noexcept {
  if (length_ == 0) return;
  passed_.set(list_[0].joint);
  suspected_.set(list_[0].joint);
}

void ReadList::forgetSilent() noexcept {
  silent_.reset();
  missed_.reset();
  misses_.fill(0);
}

void ReadList::append(const Mask& joints) noexcept {
  listed_ |= joints;
  forEachJoint(joints, [this](std::size_t joint) { list_[length_++] = {static_cast<std::uint8_t>(joint), false}; });
}

void ReadList::choosePolls() noexcept {
  if ((due_ & listed_ & ~polled_).none()) return;
  std::size_t left = polls_;
  for (std::size_t i = 0; i < length_ && left > 0; ++i) {
    if (!due_[list_[i].joint] || list_[i].poll) continue;
    list_[i].poll = true;
    polled_.set(list_[i].joint);
    --left;
  }
}

void ReadList::pollInTurn() noexcept {
  // The next joint in turn that is in the list; silent joints are skipped.
  for (std::size_t step = 0; step < kJoints && length_ > 0; ++step) {
    const std::size_t joint = (next_poll_ + step) % kJoints;
    if (!listed_[joint]) continue;
    std::ranges::find(list_, joint, &Entry::joint)->poll = true;
    polled_.set(joint);
    next_poll_ = (joint + 1) % kJoints;
    return;
  }
}

void ReadList::appendProbe() noexcept {
  if (silent_.none()) return;
  if (cycles_to_probe_ > 0 && !probe_answered_) {
    --cycles_to_probe_;
    return;
  }
  while (!silent_[next_probe_]) next_probe_ = (next_probe_ + 1) % kJoints;
  append(Mask{}.set(next_probe_));
  ++retries_;
  next_probe_ = (next_probe_ + 1) % kJoints;
  const auto interval = std::clamp(kProbeRound / static_cast<std::uint32_t>(silent_.count()), 1U, kSlowestProbe);
  cycles_to_probe_ = interval - 1;
  probe_answered_ = false;
}

void ReadList::answered(const Mask& who) noexcept {
  due_ |= ~who;
  due_ &= ~(who & polled_);
  forgive(who & listed_);
  std::size_t last_answer = length_;  // one past the last entry that answered
  while (last_answer > 0 && !who[list_[last_answer - 1].joint]) --last_answer;
  // A device missing before the last reply did reply, because the next one waits for it: only its frame was damaged. Of
  // those behind the last reply the first one is the cause; nothing is known about the others.
  if (last_answer == length_) return;
  blame(list_[last_answer].joint);
  // An unplugged cable silences the rest of its chain as well: read those after the others until they reply.
  const Chain chain = kJointTable[list_[last_answer].joint].chain;
  for (std::size_t i = last_answer + 1; i < length_; ++i)
    if (kJointTable[list_[i].joint].chain == chain) suspected_.set(list_[i].joint);
}

void ReadList::forgive(const Mask& who) noexcept {
  forEachJoint(who & missed_, [this](std::size_t joint) { misses_[joint] = 0; });
  missed_ &= ~who;
  suspected_ &= ~who;
  forEachJoint(who & tried_ & ~silent_, [this](std::size_t joint) {
    if (--on_trial_[joint] == 0) tried_.reset(joint);
  });
  forEachJoint(who & silent_, [this](std::size_t joint) {
    silent_.reset(joint);
    onTrial(joint);
    probe_answered_ = true;  // others may be back for the same reason: retry the next one at once
  });
}

void ReadList::onTrial(std::size_t joint) noexcept {
  on_trial_[joint] = kTrialCycles;
  tried_.set(joint);
}

void ReadList::blame(std::size_t joint) noexcept {
  onTrial(joint);
  if (silent_[joint]) return;
  missed_.set(joint);
  if (++misses_[joint] < kMissesUntilSilent) return;
  silent_.set(joint);
  misses_[joint] = 0;
  missed_.reset(joint);
  if (silent_.count() == 1) cycles_to_probe_ = kSlowestProbe;
}

void ReadList::powerIsOff() noexcept {
  powered_ = false;
  boot_wait_ = boot_cycles_;
  silent_.reset();
  suspected_.reset();
  missed_.reset();
  misses_.fill(0);
  tried_.reset();
  on_trial_.fill(0);
}

void ReadList::powerIsOn() noexcept {
  powered_ = true;
  if (boot_wait_ > 0) --boot_wait_;
}

}  // namespace darwinop::cm730
