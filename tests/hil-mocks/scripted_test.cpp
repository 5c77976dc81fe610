// The scripted line plays its script and reports every departure from it.
#include <gtest/gtest.h>

#include <memory>

#include "bench.hpp"
#include "hil-mocks/scripted_line.hpp"

namespace darwinop::hil {
namespace {

const auto kPingBytes = bytesOf("FF FF 01 02 01 FB");
const auto kPongBytes = bytesOf("FF FF 01 02 00 FC");

struct Complaints {
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

TEST(ScriptedLine, PlaysItsScriptOnItsClock) {
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

TEST(ScriptedLine, AnswerThatIsTooLateWaits) {
  ScriptedLine line;
  line.expect(kPingBytes).answer(kPongBytes, 3ms);
  EXPECT_EQ(line.write(kPingBytes), LineStatus::kOk);
  EXPECT_EQ(read(line, 2ms), "timeout");
  EXPECT_EQ(read(line, 4ms), hexOf(kPongBytes));
  EXPECT_EQ(line.now(), 3ms);
}

TEST(ScriptedLine, DiscardTakesAnswersThatAreDue) {
  ScriptedLine line;
  line.expect(kPingBytes).answer(kPongBytes).expect(kPingBytes);
  line.write(kPingBytes);
  line.discardInput();
  line.write(kPingBytes);
}

TEST(ScriptedLine, ComplainsAboutWrongUnexpectedAndMissingWritesAndUnreadAnswers) {
  Complaints complaints;
  {
    ScriptedLine line{complaints.collect()};
    line.expect(kPingBytes).answer(kPongBytes).expect(kPingBytes);
    line.write(kPongBytes);
    line.write(kPingBytes);
  }
  EXPECT_EQ(complaints.said,
            (std::vector<std::string>{"expected FF FF 01 02 01 FB, but FF FF 01 02 00 FC was written",
                                      "nobody expected a write now, but FF FF 01 02 01 FB was written",
                                      "2 steps were not reached; the first is the reading of FF FF 01 02 00 FC"}));
}

TEST(ScriptedLineDeathTest, AbortByDefaultWhenTheScriptIsNotConsumed) {
  EXPECT_DEATH(
      {
        ScriptedLine line;
        line.expect(kPingBytes);
      },
      "1 steps were not reached");
}

}  // namespace
}  // namespace darwinop::hil
