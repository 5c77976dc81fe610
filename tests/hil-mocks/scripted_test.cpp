// Scripted doubles: replay, and reporting of every deviation.
#include <gtest/gtest.h>

#include <memory>

#include "bench.hpp"
#include "hil-mocks/scripted_bus.hpp"
#include "hil-mocks/scripted_line.hpp"

namespace darwinop {

struct SafeCommandsForTests {
  static SafeCommands make() { return {}; }
};

namespace hil {
namespace {

const auto kPingBytes = bytesOf("FF FF 01 02 01 FB");
const auto kPongBytes = bytesOf("FF FF 01 02 00 FC");

struct Failures {
  std::vector<std::string> said;
  ScriptFailure collect() {
    return [this](const std::string& what) { said.push_back(what); };
  }
};

std::string read(ScriptedLine& line, Nanos deadline) {
  std::array<std::uint8_t, 64> into;
  std::size_t count = 0;
  const LineStatus status = line.read(into, count, deadline);
  if (status == LineStatus::kOk) return hexOf(Bytes{into}.first(count));
  return status == LineStatus::kLost ? "lost" : "timeout";
}

TEST(ScriptedLine, ReplaysItsScriptOnItsClock) {
  ScriptedLine line;
  line.expect(kPingBytes).answer(kPongBytes, 120us).silence().lose().expect(kPingBytes);
  line.advanceTo(1ms);
  EXPECT_EQ(line.write(kPingBytes), LineStatus::kOk);
  EXPECT_EQ(read(line, 5ms), hexOf(kPongBytes));
  EXPECT_EQ(line.now(), 1120us);
  EXPECT_EQ(read(line, 5ms), "timeout");
  EXPECT_EQ(line.now(), 5ms);
  EXPECT_EQ(read(line, 6ms), "lost");
  EXPECT_EQ(line.reconnects(), 1u);
  EXPECT_EQ(line.write(kPingBytes), LineStatus::kOk);
  EXPECT_TRUE(line.finished());
}

TEST(ScriptedLine, ALateReplyIsReturnedLater) {
  ScriptedLine line;
  line.expect(kPingBytes).answer(kPongBytes, 3ms);
  EXPECT_EQ(line.write(kPingBytes), LineStatus::kOk);
  EXPECT_EQ(read(line, 2ms), "timeout");
  EXPECT_EQ(read(line, 4ms), hexOf(kPongBytes));
  EXPECT_EQ(line.now(), 3ms);
}

TEST(ScriptedLine, DiscardDropsDueReplies) {
  ScriptedLine line;
  line.expect(kPingBytes).answer(kPongBytes).expect(kPingBytes);
  line.write(kPingBytes);
  line.discardInput();
  line.write(kPingBytes);
}

TEST(ScriptedLine, ReportsWrongUnexpectedAndMissingWritesAndUnreadReplies) {
  Failures failures;
  {
    ScriptedLine line{failures.collect()};
    line.expect(kPingBytes).answer(kPongBytes).expect(kPingBytes);
    line.write(kPongBytes);
    line.write(kPingBytes);
  }
  EXPECT_EQ(failures.said,
            (std::vector<std::string>{"expected FF FF 01 02 01 FB, but FF FF 01 02 00 FC was written",
                                      "nobody expected a write now, but FF FF 01 02 01 FB was written",
                                      "2 steps were not reached; the first is the reading of FF FF 01 02 00 FC"}));
}

TEST(ScriptedBus, ReplaysItsCyclesAndPassesWrites) {
  ScriptedBus bus;
  int checked = 0;
  bus.cycles(2, readingsAtRest()).expectWrite([&](const SafeCommands&) { ++checked; }).cycles(1, BusReadings{});
  BusReadings seen;
  for (const bool answered : {true, true, false}) {
    bus.write(SafeCommandsForTests::make());
    bus.read(seen);
    EXPECT_EQ(seen.board.answered, answered);
    EXPECT_EQ(seen.servo[18].position.known(), answered);
  }
  EXPECT_EQ(checked, 2);
}

TEST(ScriptedBus, ReportsMissingCyclesExtraCyclesAndWrongOrder) {
  Failures failures;
  BusReadings seen;
  {
    ScriptedBus bus{failures.collect()};
    bus.cycles(3, readingsAtRest());
    bus.read(seen);
    bus.write(SafeCommandsForTests::make());
    bus.write(SafeCommandsForTests::make());
  }
  {
    ScriptedBus bus{failures.collect()};
    bus.write(SafeCommandsForTests::make());
  }
  EXPECT_EQ(failures.said,
            (std::vector<std::string>{"read before it was written in cycle 1", "written twice in cycle 2",
                                      "2 scripted cycles were not reached, 1 were",
                                      "written after the last scripted cycle, number 0"}));
}

TEST(ScriptedDoublesDeathTest, AbortByDefaultWhenTheScriptIsNotConsumed) {
  EXPECT_DEATH(
      {
        ScriptedLine line;
        line.expect(kPingBytes);
      },
      "1 steps were not reached");
}

}  // namespace
}  // namespace hil
}  // namespace darwinop
