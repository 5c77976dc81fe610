// In-memory line: clock, determinism, faults.
#include "hil-mocks/memory_line.hpp"

#include <gtest/gtest.h>

#include "bench.hpp"
#include "core/packet.hpp"

namespace darwinop::hil {
namespace {

struct Session {
  explicit Session(std::uint64_t seed = 1) : robot{Bench::powered(), seed}, line{robot} {}

  LineStatus send(const std::string& hex) { return line.write(bytesOf(hex)); }
  /// Result of one read() within 10 ms, or "timeout" or "lost".
  std::string read(Nanos wait = 10ms) {
    std::array<std::uint8_t, 600> into;
    std::size_t count = 0;
    const LineStatus status = line.read(into, count, line.now() + wait);
    if (status == LineStatus::kOk) return hexOf(Bytes{into}.first(count));
    return status == LineStatus::kLost ? "lost" : "timeout";
  }

  VirtualRobot robot;
  MemoryLine line;
};

constexpr const char* kPing = "FF FF 01 02 01 FB";
constexpr const char* kPong = "FF FF 01 02 00 FC";

TEST(MemoryLine, ReadAdvancesToTheReplyAndNoFurther) {
  Session s;
  s.line.advanceTo(1s);
  EXPECT_EQ(s.send(kPing), LineStatus::kOk);
  EXPECT_EQ(s.line.now(), 1s);
  EXPECT_EQ(s.read(), kPong);
  EXPECT_EQ(s.line.now(), 1s + 120us);
}

TEST(MemoryLine, ReadWithoutReplyTakesUntilTheDeadline) {
  Session s;
  EXPECT_EQ(s.read(3ms), "timeout");
  EXPECT_EQ(s.line.now(), 3ms);
}

TEST(MemoryLine, AReplyUnfinishedAtTheDeadlineIsReturnedByTheNextRead) {
  Session s;
  s.send(kPing);
  EXPECT_EQ(s.read(119us), "timeout");
  EXPECT_EQ(s.line.now(), 119us);
  EXPECT_EQ(s.read(1us), kPong);
}

TEST(MemoryLine, ReturnsOneStatusFramePerRead) {
  Session s;
  s.send(withChecksum("FF FF FE 09 92 00 01 01 2A 01 02 2A"));
  EXPECT_EQ(s.read(), "FF FF 01 03 00 76 85");
  EXPECT_EQ(s.read(), "FF FF 02 03 00 76 84");
  EXPECT_EQ(s.read(), "timeout");
}

TEST(MemoryLine, SmallBufferGetsTheRestNextTime) {
  Session s;
  s.send(kPing);
  std::array<std::uint8_t, 4> into;
  std::size_t count = 0;
  EXPECT_EQ(s.line.read(into, count, 10ms), LineStatus::kOk);
  EXPECT_EQ(hexOf(Bytes{into}.first(count)), "FF FF 01 02");
  EXPECT_EQ(s.line.read(into, count, 10ms), LineStatus::kOk);
  EXPECT_EQ(hexOf(Bytes{into}.first(count)), "00 FC");
}

TEST(MemoryLine, DiscardDropsReceivedBytesOnly) {
  Session s;
  s.send(kPing);
  s.send("FF FF C8 02 01 34");
  s.line.advanceTo(150us);
  s.line.discardInput();
  EXPECT_EQ(s.read(), "FF FF C8 02 00 35");
}

TEST(MemoryLine, ReconnectsAfterUnplugging) {
  Session s;
  InjectedFault unplug;
  unplug.kind = FaultKind::kUnplug;
  unplug.at = 1ms;
  unplug.lasts = 5ms;
  s.robot.faults().add(unplug);
  s.send(kPing);
  EXPECT_EQ(s.read(), kPong);
  s.line.advanceTo(2ms);
  EXPECT_EQ(s.send(kPing), LineStatus::kLost);
  EXPECT_EQ(s.read(), "lost");
  EXPECT_EQ(s.line.reconnects(), 0u);
  s.line.advanceTo(7ms);
  EXPECT_EQ(s.line.reconnects(), 1u);
  EXPECT_EQ(s.send(kPing), LineStatus::kOk);
  EXPECT_EQ(s.read(), kPong);
}

struct Listener : WireObserver {
  std::string log;
  void request(const Frame& frame, Nanos) noexcept override { log += ">" + std::to_string(frame.id) + " "; }
  void reply(Bytes bytes, Nanos at) noexcept override {
    log += "<" + hexOf(bytes.subspan(2, 1)) + "@" + std::to_string(at.count() / 1000) + " ";
  }
};

TEST(MemoryLine, ObserverAndCountersCoverBothDirections) {
  Session s;
  Listener listener;
  s.line.observe(&listener);
  s.send(kPing);
  s.read();
  s.send("FF FF FE 04 83 1C 08 56");
  s.send(withChecksum("FF FF FE 06 92 00 01 01 2A"));
  s.read();
  EXPECT_EQ(listener.log, ">1 <01@120 >254 >254 <01@370 ");
  EXPECT_EQ(s.line.counters().frames, 3u);
  EXPECT_EQ(s.line.counters().sync_writes, 1u);
  EXPECT_EQ(s.line.counters().bulk_reads, 1u);
  EXPECT_EQ(s.line.counters().bytes_in, 13u);
}

std::string record(std::uint64_t seed) {
  Session s{seed};
  InjectedFault random;
  random.kind = FaultKind::kRandom;
  random.amount = 20;
  s.robot.faults().add(random);
  std::string all;
  for (int cycle = 0; cycle < 500; ++cycle) {
    s.line.advanceTo(cycle * 16ms);
    s.send(
        withChecksum(cycle % 2 == 0 ? "FF FF FE 09 83 1E 04 13 00 07 40 00" : "FF FF FE 09 83 1E 04 13 00 09 40 00"));
    s.send(withChecksum("FF FF FE 09 92 00 1E C8 18 06 13 24"));
    for (int i = 0; i < 4; ++i) all += s.read(3ms) + "\n";
  }
  return all;
}

TEST(MemoryLine, RunsRepeatBitForBitEvenUnderRandomFaults) {
  const std::string first = record(7);
  EXPECT_EQ(first, record(7));
  EXPECT_NE(first, record(8));
}

TEST(MemoryLine, ResultDoesNotDependOnTheStepSize) {
  Session whole, pieces;
  for (Session* s : {&whole, &pieces}) s->send(withChecksum("FF FF FE 09 83 1E 04 13 00 09 40 00"));
  whole.line.advanceTo(200ms);
  for (Nanos t{0}; t <= 200ms; t += 700us) pieces.line.advanceTo(t);
  pieces.line.advanceTo(200ms);
  for (Session* s : {&whole, &pieces}) s->send(withChecksum("FF FF 13 04 02 24 06"));
  EXPECT_EQ(whole.read(), pieces.read());
}

}  // namespace
}  // namespace darwinop::hil
