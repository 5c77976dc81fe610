#include "hal/cm730/bus.hpp"

#include <algorithm>

#include "core/sensors.hpp"

namespace darwinop::cm730 {
namespace {

// A board that has been silent for longer than safety rides through is asked alone, and only now and then: a stalled
// line answers all that was asked in the meantime, and the fewer those answers are the sooner it is current again.
constexpr std::uint32_t kCyclesUntilRest = kAnswerPatience + 1;
constexpr std::uint32_t kRestEvery = 8;
// A board write is confirmed by the next BulkRead; it is not repeated before that can have happened.
constexpr int kBoardWriteWait = 3;

}  // namespace

Cm730Bus::Cm730Bus(ByteLine& line, const BusConfig& config)
    : line_{line},
      config_{config},
      goals_{config.offsets},
      list_{config.period, config.polls(), config.absent},
      decoder_{config.offsets},
      tag_{config.fixed_block_length} {}

void Cm730Bus::send(Bytes frame) noexcept {
  if (!wrote_) began_ = line_.now();
  wrote_ = true;
  if (line_.write(frame) == LineStatus::kOk) wire_.bytes_out += static_cast<std::uint32_t>(frame.size());
}

void Cm730Bus::write(const SafeCommands& commands) noexcept {
  wrote_ = false;
  wire_ = {};
  led_wanted_ = commands.led();
  power_wanted_ = commands.powerOn();
  Bytes frame = goals_.encode(commands);
  list_.requestPolls(goals_.limitsWentAlone() ? commands.poll() | goals_.limitsAlone() : commands.poll());
  if (frame.empty() && locks_due_ > 0 && silent_cycles_ == 0 && list_.servosAreUp()) {
    frame = goals_.encodeLock();  // safety drives nobody in the first cycles after power came on
    --locks_due_;
  }
  if (!frame.empty()) send(frame);
  if (const Bytes more = goals_.takeSecond(); !more.empty()) send(more);
}

void Cm730Bus::read(BusReadings& readings) noexcept {
  readings.forget();
  if (!restThisCycle()) {
    // A board that does not answer is asked alone; replies of the servos behind it would be lost anyway.
    const auto list = silent_cycles_ >= kCyclesUntilRest ? std::span<const ReadList::Entry>{} : list_.next();
    line_.discardInput();
    reader_.clear();
    decoder_.begin(list, tag_.boardBytes(), readings);
    const std::size_t asked = sendRequest(list);
    receive(began_ + wireTime(asked));
    wire_.bus_ns = (line_.now() - began_).count();
    wire_.wire_ns = wireTime(wire_.bytes_out + wire_.bytes_in).count();
    if (readings.board.answered) board_ = readings.board;
    forEachJoint(decoder_.answered(),
                 [&](std::size_t i) { goals_.noteLoad(static_cast<Joint>(i), readings.servo[i].load); });
    learn(list);
    sendBoardWrite();
  }
  wrote_ = false;
  link_.retries = list_.retries();
  link_.bad_checksums = reader_.badChecksums();
  link_.garbage_bytes = reader_.garbageBytes();
  link_.late_replies = decoder_.lateReplies();
  link_.clamped_goals = goals_.clamped();
  link_.reconnects = line_.reconnects();
  readings.wire = wire_;
  readings.link = link_;
  readings.silent = list_.silent();
  wire_ = {};
}

bool Cm730Bus::restThisCycle() noexcept {
  if (line_.reconnects() != reconnects_seen_) {  // a new line: ask at once
    reconnects_seen_ = line_.reconnects();
    goals_.forget();
    return false;
  }
  return silent_cycles_ >= kCyclesUntilRest && silent_cycles_++ % kRestEvery != 0;
}

/// Returns the bytes that the wire has to carry before the first answer.
std::size_t Cm730Bus::sendRequest(std::span<const ReadList::Entry> list) noexcept {
  BulkReadEncoder request{frame_};
  request.add(kBoardId, kBoardWindow.address, tag_.boardBytes());
  for (const ReadList::Entry entry : list) {
    const Window window = kServoWindows[entry.poll];
    request.add(servoId(entry.joint), window.address, window.count);
  }
  send(request.finish());
  ++link_.exchanges;
  return wire_.bytes_out;
}

/// Waits for each answer as long as the wire needs for it plus the margin, and for all of them together no longer
/// than they need plus twice the margin: a line that babbles must not keep the loop.
void Cm730Bus::receive(Nanos request_done) noexcept {
  const Nanos end = request_done + wireTime(decoder_.answerBytes()) + 2 * config_.margin;
  Nanos last = request_done, now = line_.now();
  while (!decoder_.complete() && now < end) {
    std::size_t count = 0;
    const Nanos deadline = std::min(end, last + wireTime(decoder_.nextFrameBytes()) + config_.margin);
    if (line_.read(reader_.room().first(FrameReader::kRoom), count, deadline) != LineStatus::kOk) break;
    now = line_.now();
    last = std::max(last, now);
    reader_.taken(count);
    wire_.bytes_in += static_cast<std::uint32_t>(count);
    decoder_.takeAll(reader_);
  }
  // Nothing more will come: a damaged frame may hide whole ones behind it.
  decoder_.takeAll(reader_, false);
}

void Cm730Bus::learn(std::span<const ReadList::Entry> list) noexcept {
  if (!decoder_.complete() || decoder_.answered().count() != list.size()) ++link_.incomplete;
  // Late answers of servos come before the board's answer to the next request and do no harm there; a late
  // answer of the board could pass for the next one.
  tag_.note(!decoder_.boardAnswered());
  if (!decoder_.boardAnswered()) {
    list_.missedAll();
    ++silent_cycles_;
    return;
  }
  silent_cycles_ = 0;
  if (!list.empty()) list_.answered(decoder_.answered());
  if (board_.servo_power) {
    list_.powerIsOn();
  } else {
    list_.powerIsOff();
    goals_.forget();
    locks_due_ = kLocks;
  }
}

/// LEDs and servo power are compared with what the board reports, so a lost write and a board reset repair
/// themselves. Sent behind the answers, when the line is idle; the acknowledgement is not waited for.
void Cm730Bus::sendBoardWrite() noexcept {
  if (!decoder_.boardAnswered()) return;
  if (board_write_wait_ > 0 && --board_write_wait_ > 0) return;
  std::array<std::uint8_t, 16> buffer{};
  Bytes frame;
  if (power_wanted_ && !board_.servo_power) {
    // Servo power is only ever switched on here: no damaged byte may make the robot drop.
    frame = encodeWrite(buffer, kBoardId, board::kDxlPower, std::array<std::uint8_t, 1>{1});
  } else if (const std::optional<LedBytes> leds = ledsToWrite()) {
    frame = encodeWrite(buffer, kBoardId, board::kLedPanel, *leds);
  }
  if (frame.empty()) return;
  line_.write(frame);
  board_write_wait_ = kBoardWriteWait;
}

/// Registers 25..29 as wanted, or nothing when the board shows them already.
std::optional<Cm730Bus::LedBytes> Cm730Bus::ledsToWrite() const noexcept {
  const std::uint8_t panel = led_wanted_.has(LedCommand::kPanel) ? led_wanted_.panel : board_.led_panel;
  const std::uint16_t head = led_wanted_.has(LedCommand::kHead) ? led_wanted_.head : board_.led_head;
  const std::uint16_t eye = led_wanted_.has(LedCommand::kEye) ? led_wanted_.eye : board_.led_eye;
  if (panel == board_.led_panel && head == board_.led_head && eye == board_.led_eye) return std::nullopt;
  return LedBytes{panel, lowByte(head), highByte(head), lowByte(eye), highByte(eye)};
}

}  // namespace darwinop::cm730
