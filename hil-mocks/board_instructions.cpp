// Instructions that the virtual CM-730 receives, and the replies of its devices.
#include <algorithm>
#include <array>

#include "hil-mocks/virtual_board.hpp"

namespace darwinop::hil {

void VirtualBoard::execute(bool good_checksum) noexcept {
  const std::uint8_t id = parser_.id(), instruction = parser_.instruction();
  const Bytes params = parser_.params();
  if (silenced_) return;
  ++counters_.frames;
  drawUnreached();
  if (!good_checksum) ++counters_.bad_checksums;
  if (id != kBroadcastId) return executeUnicast(id, instruction, params, good_checksum);
  if (!good_checksum) return;
  if (instruction == static_cast<std::uint8_t>(Instruction::kSyncWrite)) {
    if (options_.sync_write) executeSyncWrite(params);
    return;
  }
  if (instruction == static_cast<std::uint8_t>(Instruction::kBulkRead)) {
    if (options_.bulk_read) startBulkRead(params);
    return;
  }
  forEachListener(id, [&](BusDevice& device) { carryOut(device, instruction, params); });
}

template <class F>
void VirtualBoard::forEachListener(std::uint8_t id, F&& action) noexcept {
  // Receivers are determined before effects: a write may change an id or cut the power.
  std::array<BusDevice*, kJoints + 1> listeners{};
  std::size_t count = 0;
  if (options_.board && (id == kBroadcastId || id == device_.id())) listeners[count++] = &device_;
  for (VirtualServo& s : servos_)
    if (s.listens(now_) && !unreached_[static_cast<std::size_t>(&s - servos_.data())] &&
        (id == kBroadcastId || id == s.id()))
      listeners[count++] = &s;
  for (std::size_t i = 0; i < count; ++i) action(*listeners[i]);
}

void VirtualBoard::executeUnicast(std::uint8_t id, std::uint8_t instruction, Bytes params,
                                  bool good_checksum) noexcept {
  // Status before effect: a device replies with its state before the write.
  const bool is_read = instruction == static_cast<std::uint8_t>(Instruction::kRead);
  bool on_the_bus = is_read;
  beginReply();
  forEachListener(id, [&](BusDevice& device) {
    measure(device);
    on_the_bus |= &device != &device_;  // reads of the board itself are not forwarded to the bus
    addReply(device, good_checksum ? device.answer(instruction, params) : device.answerBadChecksum(instruction));
    if (good_checksum && is_read && params.size() == 2 && &device != &device_)
      addTwin(static_cast<const VirtualServo&>(device), params[0], params[1]);
  });
  damageReply(id);
  sendReply(on_the_bus);
  if (good_checksum) forEachListener(id, [&](BusDevice& device) { carryOut(device, instruction, params); });
}

void VirtualBoard::drawUnreached() noexcept {
  for (std::size_t i = 0; i < kJoints; ++i) unreached_[i] = noise_[i] > 0 && random_.uniform() < noise_[i];
}

/// One byte of the answer of this servo.
void VirtualBoard::damageReply(std::uint8_t id) noexcept {
  if (reply_size_ == 0 || id == 0 || id > kJoints) return;
  const double chance = noise_[id - std::size_t{1}];
  if (chance > 0 && random_.uniform() < chance)
    reply_[random_.below(reply_size_)] ^= static_cast<std::uint8_t>(1 + random_.below(255));
}

void VirtualBoard::carryOut(BusDevice& device, std::uint8_t instruction, Bytes params) noexcept {
  device.carryOut(instruction, params);
  if (&device == &device_) afterBoardWrite();
}

void VirtualBoard::executeSyncWrite(Bytes params) noexcept {
  ++counters_.sync_writes;
  if (params.size() < 2) return;
  const std::uint8_t address = params[0];
  const std::size_t count = params[1];
  for (Bytes rest = params.subspan(2); count > 0 && rest.size() > count; rest = rest.subspan(count + 1)) {
    const Bytes data = rest.subspan(1, count);
    if (rest[0] == kBroadcastId) continue;  // entries need a single device
    forEachListener(rest[0], [&](BusDevice& device) {
      device.writeIfAccepted(address, data);
      if (&device == &device_) afterBoardWrite();
    });
  }
}

void VirtualBoard::startBulkRead(Bytes params) noexcept {
  ++counters_.bulk_reads;
  if (bulk_reads_to_miss_ > 0) {
    --bulk_reads_to_miss_;
    return;
  }
  turn_ = turn_count_ = 0;
  had_turn_.reset();
  if (params.empty()) return;
  for (Bytes rest = params.subspan(1); rest.size() >= 3; rest = rest.subspan(3)) {
    if (had_turn_[rest[1]]) continue;  // only the first entry of an id counts
    had_turn_[rest[1]] = true;
    turns_[turn_count_++] = {rest[0], rest[1], rest[2]};
  }
}

void VirtualBoard::nextTurn() noexcept {
  const Turn turn = turns_[turn_++];
  beginReply();
  if (turn.id != kBroadcastId)
    forEachListener(turn.id, [&](BusDevice& device) {
      if (&device == &device_ && options_.only_block != 0 && turn.count != options_.only_block) return;
      measure(device);
      addReply(device, device.answerRead(turn.address, turn.count));
      if (&device != &device_) addTwin(static_cast<const VirtualServo&>(device), turn.address, turn.count);
    });
  damageReply(turn.id);
  // Each device waits for the reply of the previous one. The board times out after 100 ms and servos never do, but by
  // then the PC has sent a new request: a silent or garbled id ends the chain.
  const bool answered =
      reply_size_ > 0 && checksum(Bytes{reply_}.subspan(2, reply_size_ - 3)) == reply_[reply_size_ - 1];
  sendReply(true);
  if (!answered) turn_count_ = 0, turn_ = 0;
}

void VirtualBoard::measure(BusDevice& device) noexcept {
  if (&device != &device_) {
    VirtualServo& s = static_cast<VirtualServo&>(device);
    s.measure(body_.state().joint[static_cast<std::size_t>(&s - servos_.data())]);
    return;
  }
  BodyState state = body_.state();
  if (acceleration_) state.accel_m_s2 = *acceleration_;
  state.buttons |= buttons_;
  device_.measure(state, rail_v_ - state.battery_drop_v);
}

void VirtualBoard::addReply(const BusDevice& device, const BusDevice::Answer& answer) noexcept {
  if (!answer.send) return;
  std::array<std::uint8_t, kMaxFrame> frame;
  const std::size_t size = encodeStatus(frame, device.id(), answer.error, answer.params).size();
  if (reply_size_ == 0) reply_delay_ = device.returnDelay();
  for (std::size_t i = 0; i < size; ++i)
    reply_[i] = i < reply_size_ ? static_cast<std::uint8_t>(reply_[i] & frame[i]) : frame[i];
  reply_size_ = std::max(reply_size_, size);
}

/// The second device with this id: same servo, another position.
void VirtualBoard::addTwin(const VirtualServo& servo, std::uint8_t address, std::uint8_t count) noexcept {
  if (!twins_[static_cast<std::size_t>(&servo - servos_.data())]) return;
  BusDevice::Answer answer = servo.answerRead(address, count);
  std::array<std::uint8_t, kMaxFrame> params;
  constexpr std::uint8_t kOther = 0x5A;
  for (std::size_t i = 0; i < answer.params.size(); ++i)
    params[i] = static_cast<std::uint8_t>(answer.params[i] ^ kOther);
  answer.params = Bytes{params}.first(answer.params.size());
  addReply(servo, answer);
}

void VirtualBoard::sendReply(bool on_the_bus) noexcept {
  if (reply_size_ == 0) return;
  const Nanos start = std::max(now_ + reply_delay_, downlink_free_);
  const Nanos end = start + options_.byte_time * static_cast<std::int64_t>(reply_size_);
  downlink_free_ = end;
  if (on_the_bus) line_free_ = end;
  ++counters_.replies;
  if (!output_.push(Bytes{reply_}.first(reply_size_), end)) counters_.lost_bytes += reply_size_;
}

}  // namespace darwinop::hil
