// Scripted byte line.
#include "hil-mocks/scripted_line.hpp"

#include <cstdio>

namespace darwinop::hil {
namespace {

std::string hexOf(Bytes bytes) {
  std::string hex;
  for (const std::uint8_t byte : bytes) {
    char text[4];
    std::snprintf(text, sizeof text, "%02X ", static_cast<unsigned>(byte));
    hex += text;
  }
  return hex.empty() ? "nothing" : hex.substr(0, hex.size() - 1);
}

}  // namespace

ScriptedLine::~ScriptedLine() {
  if (steps_.empty()) return;
  const char* kinds[] = {"a write of ", "the reading of ", "a read that times out, after ", "a lost line, after "};
  failure_(std::to_string(steps_.size()) + " steps were not reached; the first is " +
           kinds[static_cast<int>(steps_.front().kind)] + hexOf(steps_.front().bytes));
}

ScriptedLine& ScriptedLine::add(Kind kind, Bytes bytes, Nanos after) {
  steps_.push_back({kind, {bytes.begin(), bytes.end()}, after});
  return *this;
}

ScriptedLine& ScriptedLine::expect(Bytes bytes) {
  return add(Kind::kExpect, bytes, Nanos{0});
}
ScriptedLine& ScriptedLine::answer(Bytes bytes, Nanos after) {
  return add(Kind::kAnswer, bytes, after);
}
ScriptedLine& ScriptedLine::silence() {
  return add(Kind::kSilence, {}, Nanos{0});
}
ScriptedLine& ScriptedLine::lose() {
  return add(Kind::kLose, {}, Nanos{0});
}

bool ScriptedLine::takeLoss() noexcept {
  if (steps_.empty() || steps_.front().kind != Kind::kLose) return false;
  steps_.pop_front();
  ++reconnects_;
  return true;
}

LineStatus ScriptedLine::write(std::span<const std::uint8_t> bytes) noexcept {
  if (takeLoss()) return LineStatus::kLost;
  if (steps_.empty() || steps_.front().kind != Kind::kExpect) {
    failure_("unexpected write of " + hexOf(bytes));
    return LineStatus::kOk;
  }
  const Step step = std::move(steps_.front());
  steps_.pop_front();
  since_ = now_;
  if (!std::ranges::equal(step.bytes, bytes))
    failure_("expected " + hexOf(step.bytes) + ", but " + hexOf(bytes) + " was written");
  return LineStatus::kOk;
}

LineStatus ScriptedLine::read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept {
  count = 0;
  if (takeLoss()) return LineStatus::kLost;
  const bool answered = !steps_.empty() && steps_.front().kind == Kind::kAnswer;
  if (!answered || since_ + steps_.front().after > deadline) {
    if (!steps_.empty() && steps_.front().kind == Kind::kSilence) steps_.pop_front();
    now_ = std::max(now_, deadline);
    return LineStatus::kTimeout;
  }
  Step& step = steps_.front();
  since_ += step.after;
  step.after = Nanos{0};
  now_ = std::max(now_, since_);
  count = std::min(into.size(), step.bytes.size());
  std::copy_n(step.bytes.begin(), count, into.begin());
  step.bytes.erase(step.bytes.begin(), step.bytes.begin() + static_cast<std::ptrdiff_t>(count));
  if (step.bytes.empty()) steps_.pop_front();
  return LineStatus::kOk;
}

void ScriptedLine::discardInput() noexcept {
  while (!steps_.empty() && steps_.front().kind == Kind::kAnswer && since_ + steps_.front().after <= now_) {
    since_ += steps_.front().after;
    steps_.pop_front();
  }
}

}  // namespace darwinop::hil
