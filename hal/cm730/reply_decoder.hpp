// Decodes the replies to one BulkRead into readings in SI units. A missing reply leaves its reading unanswered.
#pragma once

#include <cstddef>
#include <span>

#include "core/packet.hpp"
#include "hal/cm730/imu_correction.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "hal/cm730/read_list.hpp"
#include "hal/cm730/stall_torques.hpp"
#include "hal/cm730/wire.hpp"
#include "hal/servo_bus.hpp"

namespace darwinop::cm730 {

/// A late reply to an earlier request must never be taken for a new one. The board is read first, with a number of
/// bytes that differs between successive requests (`first_bytes`, request_tag.hpp); frames count only after a board
/// reply of exactly that length, and then only in list order. Without a board the first servo of the list takes its
/// place.
class ReplyDecoder {
 public:
  explicit ReplyDecoder(const JointOffsets& offsets = {}, const StallTorques& stall = {}, const ImuCorrection& imu = {},
                        bool board = true)
      : offsets_{offsets}, stall_{stall}, imu_{imu}, board_{board} {}

  void begin(std::span<const ReadList::Entry> list, std::uint8_t first_bytes, BusReadings& readings) noexcept;
  /// Takes all frames of `reader`. `more_expected`: see FrameReader::next(). A frame that is not followed directly by
  /// another one (FrameReader::boundaryLost) may be damaged and does not count.
  void takeAll(FrameReader& reader, bool more_expected = true) noexcept {
    while (const auto frame = reader.next(more_expected)) {
      if (reader.boundaryLost()) withdraw();
      take(*frame);
    }
    if (reader.boundaryLost()) withdraw();
  }
  void take(const Frame& frame) noexcept {
    last_ = Taken::kNothing;
    if (frame.id == kBoardId)
      takeBoard(frame);
    else
      takeServo(frame);
  }

  /// True if no more replies are expected.
  [[nodiscard]] bool complete() const noexcept { return first_answered_ && position_ == list_.size(); }
  /// Bytes of all replies to this request.
  [[nodiscard]] std::size_t answerBytes() const noexcept;
  /// Bytes of the next expected frame; 0 if complete.
  [[nodiscard]] std::size_t nextFrameBytes() const noexcept;
  /// The board has answered; without a board the first servo of the list.
  [[nodiscard]] bool firstAnswered() const noexcept { return first_answered_; }
  [[nodiscard]] const ReadList::Mask& answered() const noexcept { return answered_; }
  [[nodiscard]] const ReadList::Mask& polled() const noexcept { return polled_; }
  [[nodiscard]] std::uint32_t lateReplies() const noexcept { return late_; }

 private:
  /// Discards the frame taken last.
  void withdraw() noexcept;
  void takeBoard(const Frame& frame) noexcept;
  void takeServo(const Frame& frame) noexcept;
  [[gnu::cold, gnu::noinline]] void takeFirst(const Frame& frame) noexcept;
  void takePoll(Joint joint, Bytes block, ServoReading& out) noexcept;

  JointOffsets offsets_;
  StallTorques stall_;
  ImuCorrection imu_;
  std::span<const ReadList::Entry> list_;
  BusReadings* readings_ = nullptr;
  bool board_;
  std::uint8_t first_bytes_ = 0;
  bool first_answered_ = false;
  std::size_t position_ = 0;  // entries before it have replied or were skipped
  enum class Taken : std::uint8_t { kNothing, kBoard, kServo } last_ = Taken::kNothing;
  ReadList::Mask answered_, polled_;
  std::uint32_t late_ = 0;
};

}  // namespace darwinop::cm730
