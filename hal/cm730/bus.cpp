#include "hal/cm730/bus.hpp"

#include <algorithm>

#include "core/sensors.hpp"

namespace darwinop::cm730 {
namespace {

// After more missing replies than safety tolerates, only the board is read, and only every kRestEvery cycles: a stalled
// line later delivers the replies to all requests, so fewer requests make it current again sooner.
constexpr std::uint32_t kCyclesUntilRest = kAnswerPatience + 1;
constexpr std::uint32_t kRestEvery = 8;
// Cycles until a board write is repeated: the next BulkRead confirms it.
constexpr int kBoardWriteWait = 3;

}  // namespace

Cm730Bus::Cm730Bus(ByteLine& line, const BusConfig& config)
    : line_{line},
      config_{config},
      goals_{config.offsets, config.stall},
      list_{config.period, config.polls(), config.absent, config.board},
      decoder_{config.offsets, config.stall, config.imu, config.board},
      tag_{config.fixed_block_length, config.board} {
  if (!config.board) list_.missedAll();  // only polls show whether the servos have restarted
}

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
    frame = goals_.encodeLock(
        ~(config_.absent | config_.no_writes));  // no joint is driven in the first cycles after power-up
    --locks_due_;
  }
  if (!frame.empty()) send(frame);
  if (const Bytes more = goals_.takeSecond(); !more.empty()) send(more);
}

/// If the board does not reply, only the board is read: the servos' replies would be lost as well. Without a board,
/// only one servo.
inline std::span<const ReadList::Entry> Cm730Bus::nextList() noexcept {
  if (silent_cycles_ < kCyclesUntilRest) [[likely]]
    return list_.next();
  return config_.board ? std::span<const ReadList::Entry>{} : list_.nextAlone();
}

void Cm730Bus::read(BusReadings& readings) noexcept {
  readings.forget();
  readings.board.absent = !config_.board;
  if (!restThisCycle()) {
    const auto list = nextList();
    line_.discardInput();
    reader_.clear();
    decoder_.begin(list, tag_.bytes(), readings);
    const std::size_t asked = sendRequest(list);
    receive(began_ + wireTime(asked));
    wire_.bus_ns = (line_.now() - began_).count();
    wire_.wire_ns = wireTime(wire_.bytes_out + wire_.bytes_in).count();
    if (readings.board.answered) board_ = readings.board;
    forEachJoint(decoder_.polled(),
                 [&](std::size_t i) { goals_.noteLimit(static_cast<Joint>(i), readings.servo[i].torque_limit); });
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
  if (line_.reconnects() != reconnects_seen_) {  // a new line: read at once
    reconnects_seen_ = line_.reconnects();
    goals_.forget();
    return false;
  }
  return silent_cycles_ >= kCyclesUntilRest && silent_cycles_++ % kRestEvery != 0;
}

/// Returns the number of bytes sent before the first reply.
std::size_t Cm730Bus::sendRequest(std::span<const ReadList::Entry> list) noexcept {
  BulkReadEncoder request{frame_};
  if (config_.board) {
    request.add(kBoardId, kBoardWindow.address, tag_.bytes());
  } else if (!list.empty()) {
    request.add(servoId(list[0].joint), taggedPoll(tag_.bytes()).address, tag_.bytes());
    list = list.subspan(1);
  }
  for (const ReadList::Entry entry : list) {
    const RegisterWindow window = kServoWindows[entry.poll];
    request.add(servoId(entry.joint), window.address, window.count);
  }
  send(request.finish());
  ++link_.exchanges;
  return wire_.bytes_out;
}

/// Waits for each reply for its transmission time plus the margin, and for all replies at most their transmission time
/// plus twice the margin: a line with continuous garbage must not block the loop.
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
  // No more bytes will arrive: there may be complete frames behind a damaged one.
  decoder_.takeAll(reader_, false);
}

void Cm730Bus::learn(std::span<const ReadList::Entry> list) noexcept {
  if (!decoder_.complete() || decoder_.answered().count() != list.size()) ++link_.incomplete;
  // A late reply of a servo arrives before the board's next reply and is discarded there; a late reply of the board
  // could be taken for the reply to the next request.
  tag_.note(!decoder_.firstAnswered());
  if (!config_.board) [[unlikely]]
    return learnWithoutBoard();
  if (!decoder_.firstAnswered()) {
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

/// A servo boots in about 0.2 s, so a supply that was interrupted shows as silence, after which every EEPROM has to be
/// locked again. Settings need not be forgotten: safety drives no joint by then.
void Cm730Bus::learnWithoutBoard() noexcept {
  if (!decoder_.firstAnswered()) {
    list_.missedAll();
    list_.leaderMissed();
    if (++silent_cycles_ == kCyclesUntilRest) list_.forgetSilent();
    return;
  }
  if (silent_cycles_ >= kCyclesUntilRest) locks_due_ = kLocks;
  silent_cycles_ = 0;
  list_.leaderAnswered();
  list_.answered(decoder_.answered());
  list_.powerIsOn();
}

/// Writes LEDs and servo power if they differ from what the board reports, so a lost write or a board reset is
/// corrected. Sent after the replies, when the line is idle; does not wait for the acknowledgement.
void Cm730Bus::sendBoardWrite() noexcept {
  if (!config_.board || !decoder_.firstAnswered()) return;
  if (board_write_wait_ > 0 && --board_write_wait_ > 0) return;
  std::array<std::uint8_t, 16> buffer{};
  Bytes frame;
  if (power_wanted_ && !board_.servo_power) {
    // Servo power is never switched off: a damaged byte must not make the robot drop.
    frame = encodeWrite(buffer, kBoardId, board::kDxlPower, std::array<std::uint8_t, 1>{1});
  } else if (const std::optional<LedBytes> leds = ledsToWrite()) {
    frame = encodeWrite(buffer, kBoardId, board::kLedPanel, *leds);
  }
  if (frame.empty()) return;
  line_.write(frame);
  board_write_wait_ = kBoardWriteWait;
}

/// Requested values of registers 25..29; nothing if the board has them already.
std::optional<Cm730Bus::LedBytes> Cm730Bus::ledsToWrite() const noexcept {
  const std::uint8_t panel = led_wanted_.has(LedCommand::kPanel) ? led_wanted_.panel : board_.led_panel;
  const std::uint16_t head = led_wanted_.has(LedCommand::kHead) ? led_wanted_.head : board_.led_head;
  const std::uint16_t eye = led_wanted_.has(LedCommand::kEye) ? led_wanted_.eye : board_.led_eye;
  if (panel == board_.led_panel && head == board_.led_head && eye == board_.led_eye) return std::nullopt;
  return LedBytes{panel, lowByte(head), highByte(head), lowByte(eye), highByte(eye)};
}

}  // namespace darwinop::cm730
