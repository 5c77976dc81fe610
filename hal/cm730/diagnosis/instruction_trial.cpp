// Tests BulkRead and SyncWrite as the loop sends them, with retries.
#include "hal/cm730/diagnosis/instruction_trial.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <vector>

#include "core/packet.hpp"
#include "core/registers.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"
#include "hal/cm730/request_tag.hpp"
#include "hal/cm730/wire.hpp"

namespace darwinop::cm730 {
namespace {

constexpr std::uint8_t kTrialLed = find(kMx28, "led").address;
constexpr std::size_t kLedAt = kTrialLed - kServoPoll.address;
constexpr int kTries = 6;                  // single losses are normal, and a busy PC stalls
constexpr Nanos kMargin{15'000'000};       // scheduling delay of a busy PC
constexpr Nanos kLateReplies{40'000'000};  // wait after an incomplete exchange
constexpr Nanos kUntilWritten{1'000'000};  // from the end of a SYNC_WRITE to its effect

class Trial {
 public:
  Trial(ByteLine& line, RobotFacts& facts) : line_{line}, facts_{facts} {
    for (std::size_t i = 0; i < kJoints; ++i)
      if (isSupported(facts.servo[i], facts.permitted)) list_.push_back(i);
  }

  void run() {
    InstructionFacts& result = facts_.instructions;
    if (list_.empty()) return;
    result.tried = true;
    tryBulkRead();
    if (!result.bulk_read) return;
    trySyncWrite();
    // With a slow port each length would cost the full delay; the cycle is too long in any case.
    if (facts_.round_trip.median < kLatencySignature) tryBlockLengths();
  }

 private:
  /// One BulkRead of the board and `servos`. Returns true if the board answered; without a board, if a servo did.
  /// Results: `answered_`, `led_`.
  bool exchange(std::uint8_t board_bytes, const std::vector<std::size_t>& servos,
                std::uint8_t servo_bytes = kServoPoll.count) {
    std::array<std::uint8_t, kMaxFrame> frame{};
    BulkReadEncoder request{frame};
    std::size_t bytes = 0;
    if (!facts_.board.absent) {
      request.add(kBoardId, kBoardWindow.address, board_bytes);
      bytes = board_bytes + kFrameOverhead;
    }
    servo_bytes_ = servo_bytes;
    for (const std::size_t i : servos) {
      request.add(kJointTable[i].id, taggedPoll(servo_bytes).address, servo_bytes);
      bytes += servo_bytes + kFrameOverhead;
    }
    const Bytes sent = request.finish();
    line_.discardInput();
    if (!send(sent)) return false;
    return receive(board_bytes, servos.size(), line_.now() + wireTime(sent.size() + bytes) + kMargin);
  }

  bool send(Bytes frame) {
    const LineStatus status = line_.write(frame);
    facts_.lost = facts_.lost || status == LineStatus::kLost;
    return status == LineStatus::kOk;
  }

  bool receive(std::uint8_t board_bytes, std::size_t servos, Nanos deadline) {
    bool board = facts_.board.absent;
    answered_.reset();
    FrameReader reader;
    std::array<std::uint8_t, 512> incoming{};
    while (!(board && answered_.count() == servos)) {
      std::size_t count = 0;
      const LineStatus status = line_.read(incoming, count, deadline);
      facts_.lost = facts_.lost || status == LineStatus::kLost;
      if (status != LineStatus::kOk) break;
      for (Bytes rest{incoming.data(), count}; !rest.empty();) {
        rest = rest.subspan(reader.feed(rest));
        while (const auto frame = reader.next()) take(*frame, board_bytes, board);
      }
      if (line_.now() >= deadline) break;
    }
    // A late reply would be taken for the reply to the next request.
    const bool missing = !board || answered_.count() != servos;
    if (missing && !facts_.lost && pass(line_, kLateReplies) == LineStatus::kLost) facts_.lost = true;
    return facts_.board.absent ? answered_.any() : board;
  }

  void take(const Frame& frame, std::uint8_t board_bytes, bool& board) {
    if (frame.id == kBoardId && frame.params.size() == board_bytes) board = true;
    if (frame.id < 1 || frame.id > kJoints || frame.params.size() != servo_bytes_) return;
    const std::size_t i = frame.id - 1u;
    answered_.set(i);
    led_[i] = frame.params.last(kServoPoll.count)[kLedAt] != 0;
  }

  void tryBulkRead() {
    std::bitset<kJoints> answered;
    bool first_answered = false;
    // Also repeated if only the board's reply was lost.
    const auto complete = [&] { return facts_.instructions.bulk_read && answered.count() == list_.size(); };
    for (int i = 0; i < kTries && !facts_.lost && !complete(); ++i) {
      facts_.instructions.bulk_read |= exchange(kBoardWindow.count, list_);
      answered |= answered_;
      if (i == 0) first_answered = facts_.instructions.bulk_read || answered.any();
      if (!facts_.instructions.bulk_read) continue;
      // A silent servo suppresses the replies of those after it, so it is read last in the next attempt.
      std::vector<std::size_t> order;
      for (const bool has_answered : {true, false})
        for (const std::size_t joint : list_)
          if (answered[joint] == has_answered) order.push_back(joint);
      list_ = order;
    }
    if (!facts_.instructions.bulk_read || facts_.lost) return;
    facts_.instructions.first_lost = !first_answered;
    markMissing(answered);
  }

  /// Reads missing servos one at a time, so that one does not suppress another.
  void markMissing(std::bitset<kJoints> answered) {
    for (const std::size_t i : list_) {
      for (int attempt = 0; attempt < kTries && !answered[i] && !facts_.lost; ++attempt) {
        exchange(kBoardWindow.count, {i});
        answered |= answered_;
      }
      if (!facts_.lost) facts_.servo[i].bulk_read_works = answered[i];
    }
    std::erase_if(list_, [&](std::size_t i) { return !answered[i]; });
  }

  void trySyncWrite() {
    std::bitset<kJoints> obeyed;
    for (int i = 0; i < kTries && !facts_.lost && obeyed.count() < list_.size(); ++i) {
      obeyed |= obeyedLed(true);
      obeyed |= obeyedLed(false);
    }
    // A lost frame must not leave a LED on; if no servo executed it, nothing has changed.
    for (int i = 0; i < kTries && !facts_.lost && obeyed.any() && !ledsAsFound(); ++i) obeyedLed(false);
    facts_.instructions.sync_write = obeyed.any() || facts_.lost;
    if (!obeyed.any() || facts_.lost) return;
    for (const std::size_t i : list_) facts_.servo[i].sync_write_works = obeyed[i];
  }

  [[nodiscard]] bool ledsAsFound() const {
    return std::ranges::all_of(list_, [&](std::size_t i) { return answered_[i] && led_[i] == facts_.servo[i].led_on; });
  }

  /// Writes all LEDs, inverted or original, and reads them back. Only a change is proof.
  std::bitset<kJoints> obeyedLed(bool changed) {
    std::array<std::uint8_t, kMaxFrame> frame{};
    SyncWriteEncoder sync{frame, kTrialLed, 1};
    for (const std::size_t i : list_) {
      const std::uint8_t value = facts_.servo[i].led_on != changed ? 1 : 0;
      sync.add(kJointTable[i].id, Bytes{&value, 1});
    }
    const Bytes request = sync.finish();
    if (!send(request)) return {};
    if (pass(line_, wireTime(request.size()) + kUntilWritten) == LineStatus::kLost) facts_.lost = true;
    exchange(kBoardWindow.count, list_);
    std::bitset<kJoints> obeyed;
    for (const std::size_t i : list_) obeyed[i] = changed && answered_[i] && led_[i] != facts_.servo[i].led_on;
    return obeyed;
  }

  void tryBlockLengths() {
    if (facts_.board.absent) return tryServoLengths();
    for (std::uint8_t bytes = kBoardWindow.count; bytes <= RequestTag::kMostBytes && !facts_.lost; ++bytes) {
      bool answered = false;
      for (int i = 0; i < kTries && !answered && !facts_.lost; ++i) answered = exchange(bytes, {});
      if (answered || facts_.lost) continue;
      facts_.instructions.all_blocks = false;
      return;
    }
  }

  /// Any servo may be the one that carries the request tag.
  void tryServoLengths() {
    for (std::uint8_t bytes = RequestTag::kLeastServoBytes; bytes <= RequestTag::kMostServoBytes && !facts_.lost;
         ++bytes) {
      std::bitset<kJoints> answered;
      for (int i = 0; i < kTries && answered.count() < list_.size() && !facts_.lost; ++i) {
        exchange(0, list_, bytes);
        answered |= answered_;
      }
      if (answered.count() == list_.size() || facts_.lost) continue;
      facts_.instructions.all_blocks = false;
      return;
    }
  }

  ByteLine& line_;
  RobotFacts& facts_;
  std::uint8_t servo_bytes_ = kServoPoll.count;
  std::vector<std::size_t> list_;  // joints in reading order
  std::bitset<kJoints> answered_, led_;
};

}  // namespace

void tryInstructions(ByteLine& line, RobotFacts& facts) {
  Trial{line, facts}.run();
}

}  // namespace darwinop::cm730
