// Time, wire and instructions of the virtual CM-730.
#include "hil-mocks/virtual_board.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hil-mocks/fault.hpp"

namespace darwinop::hil {
namespace {

// In the order x, y, z.
constexpr std::array<const Register*, 3> kGyro{&find(kCm730, "gyro_x"), &find(kCm730, "gyro_y"),
                                               &find(kCm730, "gyro_z")};
constexpr std::array<const Register*, 3> kAccel{&find(kCm730, "accel_x"), &find(kCm730, "accel_y"),
                                                &find(kCm730, "accel_z")};

std::uint16_t countsOf(const Register& r, double si) {
  const double raw = std::nearbyint(si / r.scale + r.zero);
  return static_cast<std::uint16_t>(std::clamp(raw, double{0}, static_cast<double>(r.high)));
}

constexpr std::uint8_t kSupply = find(kCm730, "voltage").address;
constexpr std::uint8_t kButtons = find(kCm730, "buttons").address;

}  // namespace

BoardDevice::BoardDevice(std::uint16_t model, std::uint8_t firmware) : BusDevice{kBoardLayout} {
  table_.setWord(find(kCm730, "model").address, model);
  table_.setByte(board::kFirmware, firmware);
}

void BoardDevice::measure(const BodyState& body, double supply_v) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    table_.setWord(kGyro[axis]->address, countsOf(*kGyro[axis], body.gyro_rad_s[axis]));
    table_.setWord(kAccel[axis]->address, countsOf(*kAccel[axis], body.accel_m_s2[axis]));
  }
  table_.setByte(kButtons, body.buttons);
  table_.setByte(kSupply, static_cast<std::uint8_t>(std::clamp(std::nearbyint(supply_v * 10), 0.0, 255.0)));
}

void BoardDevice::restart() {
  table_.reset(Memory::kRam);
  forgetRegistered();
}

VirtualBoard::VirtualBoard(const BoardOptions& options, Body& body)
    : options_{options},
      body_{body},
      device_{options.model, options.firmware},
      supply_v_{options.supply_v},
      rail_v_{supply_v_} {
  boot_.fill(options.servo_boot);
  servos_.reserve(kJoints);
  for (std::size_t i = 0; i < kJoints; ++i) {
    servos_.emplace_back(static_cast<Joint>(i), options.servo[i]);
    servos_[i].setUsualTemperature(options.temperature_c);
    servos_[i].setSupply(options.supply_v);
    servos_[i].measure(body_.state().joint[i]);
  }
  device_.setServoPower(options.servo_power);
  afterBoardWrite();
}

void VirtualBoard::receive(Bytes bytes, Nanos when) noexcept {
  input_.push(bytes, std::max(when, now_));
  counters_.lost_bytes = input_.lost();
}

std::optional<Nanos> VirtualBoard::nextEvent() const noexcept {
  if (stalled_until_ == Nanos::max()) return std::nullopt;
  if (turn_ < turn_count_) return std::max(free(), now_);
  if (input_.empty()) return std::nullopt;
  return std::max({input_.when(), free(), now_}) + options_.byte_time;
}

std::optional<Nanos> VirtualBoard::earliestReply() const noexcept {
  const std::optional<Nanos> next = nextEvent();
  if (!next || turn_ < turn_count_) return next;
  return *next + options_.byte_time * static_cast<std::int64_t>(parser_.missing() - 1);
}

void VirtualBoard::advance(Nanos until, bool stop_at_reply) noexcept {
  while (true) {
    const std::optional<Nanos> next = nextEvent();
    if (!next || *next > until) break;
    stepBody(*next);
    now_ = *next;
    if (turn_ < turn_count_) {
      nextTurn();
    } else {
      takeByte();
    }
    if (stop_at_reply && !output_.empty()) return;
  }
  if (until > now_) {
    stepBody(until);
    now_ = until;
  }
}

void VirtualBoard::stepBody(Nanos until) noexcept {
  while (body_time_ + options_.body_step <= until) {
    if (sag_v_ > 0) sagSupply();
    for (std::size_t i = 0; i < kJoints; ++i) {
      servos_[i].strain(options_.body_step);
      drives_[i] = servos_[i].drive(body_.state().joint[i]);
    }
    body_.step(options_.body_step, drives_);
    if (body_.error() != nullptr && !silenced_) {
      silenced_ = true;
      std::fprintf(stderr, "darwinop: %s\n", body_.error());
    }
    body_time_ += options_.body_step;
  }
}

void VirtualBoard::sagSupply() noexcept {
  double load = 0;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (servos_[i].state().pulls()) load += std::abs(body_.state().joint[i].load) / kJoints;
  rail_v_ = std::max(0.0, supply_v_ - sag_v_ * load);
  for (VirtualServo& s : servos_) s.setSupply(rail_v_);
  if (rail_v_ >= kBrownOutV) return;
  for (VirtualServo& s : servos_) s.powerDown();
  afterBoardWrite();  // without load the supply recovers
}

void VirtualBoard::takeByte() noexcept {
  const InstructionParser::Result result = parser_.take(input_.pop(), now_);
  line_free_ = now_;
  if (result == InstructionParser::Result::kMore) return;
  execute(result == InstructionParser::Result::kFrame);
}

void VirtualBoard::execute(bool good_checksum) noexcept {
  const std::uint8_t id = parser_.id(), instruction = parser_.instruction();
  const Bytes params = parser_.params();
  if (silenced_) return;
  ++counters_.frames;
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
  if (id == kBroadcastId || id == device_.id()) listeners[count++] = &device_;
  for (VirtualServo& s : servos_)
    if (s.listens(now_) && (id == kBroadcastId || id == s.id())) listeners[count++] = &s;
  for (std::size_t i = 0; i < count; ++i) action(*listeners[i]);
}

void VirtualBoard::executeUnicast(std::uint8_t id, std::uint8_t instruction, Bytes params,
                                  bool good_checksum) noexcept {
  // Status before effect: a device replies with its state before the write.
  bool on_the_bus = instruction == static_cast<std::uint8_t>(Instruction::kRead);
  beginReply();
  forEachListener(id, [&](BusDevice& device) {
    measure(device);
    on_the_bus |= &device != &device_;  // reads of the board itself are not forwarded to the bus
    addReply(device, good_checksum ? device.answer(instruction, params) : device.answerBadChecksum(instruction));
  });
  sendReply(on_the_bus);
  if (good_checksum) forEachListener(id, [&](BusDevice& device) { carryOut(device, instruction, params); });
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
  // Each device waits for the reply of the previous one. The board times out after 100 ms and servos never do, but by
  // then the PC has sent a new request: a silent or garbled id ends the chain.
  const bool answered =
      reply_size_ > 0 && checksum(Bytes{reply_}.subspan(2, reply_size_ - 3)) == reply_[reply_size_ - 1];
  sendReply(true);
  if (!answered) turn_count_ = 0, turn_ = 0;
}

void VirtualBoard::afterBoardWrite() noexcept {
  for (VirtualServo& s : servos_) {
    if (device_.servoPower()) {
      measure(s);  // its goal becomes its present position
      s.powerUp(now_, boot_[static_cast<std::size_t>(&s - servos_.data())]);
    } else {
      s.powerDown();
    }
  }
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
  device_.measure(state, rail_v_);
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

void VirtualBoard::babble(Bytes bytes) noexcept {
  downlink_free_ = std::max(now_, downlink_free_) + options_.byte_time * static_cast<std::int64_t>(bytes.size());
  if (!output_.push(bytes, downlink_free_)) counters_.lost_bytes += bytes.size();
}

void VirtualBoard::observe(ServoObserver* observer) noexcept {
  for (VirtualServo& s : servos_) s.observe(observer);
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

void VirtualBoard::setServoDead(Joint joint, bool dead) noexcept {
  servoOf(joint).setDead(dead);
  afterBoardWrite();
}

void VirtualBoard::setSupply(double volt) noexcept {
  supply_v_ = rail_v_ = volt;
  for (VirtualServo& s : servos_) s.setSupply(volt);
}

void VirtualBoard::pressReset() noexcept {
  device_.restart();
  afterBoardWrite();
  parser_.clear();
  turn_ = turn_count_ = 0;
}

}  // namespace darwinop::hil
