// The three kinds of work that are compared, each as one call a cycle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/conversions.hpp"
#include "core/packet.hpp"
#include "core/registers.hpp"
#include "loop_under_test.hpp"
#include "plain_wrapper.hpp"

namespace darwinop::bench {

/// What board and servos answer to one BulkRead.
inline std::vector<std::uint8_t> replyOf(int servos) {
  std::vector<std::uint8_t> reply;
  std::array<std::uint8_t, kMaxFrame> buffer{};
  const auto append = [&](int id, std::size_t count) {
    std::vector<std::uint8_t> data(count, 2);
    const auto frame = encodeStatus(buffer, static_cast<std::uint8_t>(id), 0, data);
    reply.insert(reply.end(), frame.begin(), frame.end());
  };
  append(kBoardId, 30);
  for (int id = 1; id <= servos; ++id) append(id, 6);
  return reply;
}

/// The whole loop but the line: commands in, safety, encode, decode, publish, account.
class LoopWork {
 public:
  LoopWork(int servos, std::uint64_t cycles)
      : recording_{record(static_cast<std::size_t>(servos), kWarmUp + cycles)},
        line_{recording_},
        loop_{line_, static_cast<std::size_t>(servos)},
        servos_{servos} {
    for (std::uint64_t i = 0; i < kWarmUp; ++i) loop_.cycle();
  }
  void prepare() { loop_.publish(); }
  void run() { loop_.turn(); }
  [[nodiscard]] bool plausible() const {
    const Sensors sensors = loop_.sensors();
    int driven = 0, fresh = 0;
    for (const JointSensors& joint : sensors.joint) {
      driven += joint.driven ? 1 : 0;
      fresh += joint.motion.fresh() ? 1 : 0;
    }
    return driven == servos_ && fresh == servos_ && sensors.board.motion.fresh();
  }

 private:
  Recording recording_;
  ReplayLine line_;
  LoopUnderTest<ReplayLine> loop_;
  int servos_;
};

/// The packet code of core/ alone: goals out, positions back.
class CodecWork {
 public:
  explicit CodecWork(int servos) : servos_{servos}, reply_{replyOf(servos)} {}
  void prepare() {}
  void run() {
    SyncWriteEncoder sync{frame_, servo::kGoalPosition, 2};
    for (int id = 1; id <= servos_; ++id) {
      const auto goal = static_cast<std::uint16_t>(ticksFromRad(Rad{0.01 * id}));
      sync.add(static_cast<std::uint8_t>(id), std::array{lowByte(goal), highByte(goal)});
    }
    sent_ += sync.finish().size();
    BulkReadEncoder bulk{frame_};
    bulk.add(kBoardId, 24, 30);
    for (int id = 1; id <= servos_; ++id) bulk.add(static_cast<std::uint8_t>(id), servo::kPresentPosition, 6);
    sent_ += bulk.finish().size();

    found_ = 0;
    reader_.clear();
    for (Bytes rest{reply_}; !rest.empty();) {
      rest = rest.subspan(reader_.feed(rest));
      while (const auto frame = reader_.next()) {
        ++found_;
        if (frame->id != kBoardId) sum_ += radFromTicks(wordAt(frame->params, 0)).value;
      }
    }
  }
  [[nodiscard]] bool plausible() const { return found_ == servos_ + 1 && sum_ != 0 && sent_ > 0; }

 private:
  int servos_, found_ = 0;
  std::vector<std::uint8_t> reply_;
  std::array<std::uint8_t, kMaxFrame> frame_{};
  FrameReader reader_;
  double sum_ = 0;
  std::size_t sent_ = 0;
};

/// The peer.
class PlainWork {
 public:
  PlainWork(int servos, bool goals_only) : servos_{servos}, wrapper_{servos, goals_only}, reply_{replyOf(servos)} {}
  void prepare() {}
  void run() {
    for (int i = 0; i < servos_; ++i) wrapper_.setGoal(i, 0.01 * i);
    sent_ += wrapper_.encode();
    found_ = wrapper_.decode(reply_.data(), reply_.size());
    sum_ += wrapper_.sum();
  }
  [[nodiscard]] bool plausible() const { return found_ == servos_ + 1 && sum_ != 0 && sent_ > 0; }

 private:
  int servos_, found_ = 0;
  PlainWrapper wrapper_;
  std::vector<std::uint8_t> reply_;
  double sum_ = 0;
  std::size_t sent_ = 0;
};

}  // namespace darwinop::bench
