// One request, one answer: what counts as the answer, and how long it is waited for.
#include "hal/cm730/diagnosis/transactions.hpp"

#include <gtest/gtest.h>

#include "core/registers.hpp"
#include "hal/cm730/wire.hpp"
#include "hil-mocks/scripted_line.hpp"

namespace darwinop::cm730 {
namespace {

using namespace std::chrono_literals;

using Octets = std::vector<std::uint8_t>;

Octets pingFrame(std::uint8_t id) {
  std::array<std::uint8_t, kMaxFrame> frame;
  const auto used = encodePing(frame, id);
  return {used.begin(), used.end()};
}
Octets readFrame(std::uint8_t id, std::uint8_t address, std::uint8_t count) {
  std::array<std::uint8_t, kMaxFrame> frame;
  const auto used = encodeRead(frame, id, address, count);
  return {used.begin(), used.end()};
}
Octets statusFrame(std::uint8_t id, const Octets& params = {}, std::uint8_t error = 0) {
  std::array<std::uint8_t, kMaxFrame> frame;
  const auto used = encodeStatus(frame, id, error, params);
  return {used.begin(), used.end()};
}
Octets joined(Octets first, const Octets& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

struct Line : hil::ScriptedLine {
  Line() : ScriptedLine{[](const std::string& what) { ADD_FAILURE() << what; }} {}
};
const Octets kRead = readFrame(1, 36, 2);

TEST(Transactions, AReadReturnsRegistersAndErrorBits) {
  Line line;
  line.expect(readFrame(19, 36, 2)).answer(statusFrame(19, {0xDC, 0x05}, error_bit::kOverload), 200us);
  const Answer answer = readRegisters(line, 19, 36, 2);
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(wordAt(answer.data(), 0), 1500);
  EXPECT_EQ(answer.error_bits, error_bit::kOverload);
  EXPECT_EQ(answer.tries, 1);
  EXPECT_EQ(answer.took, 200us);
  EXPECT_FALSE(answer.garbled);
}

TEST(Transactions, SilenceIsRetriedAndTheAttemptsAreCounted) {
  Line line;
  line.expect(pingFrame(1)).silence().expect(pingFrame(1)).silence().expect(pingFrame(1)).answer(statusFrame(1));
  const Answer answer = ping(line, 1);
  EXPECT_TRUE(answer.ok());
  EXPECT_EQ(answer.tries, 3);
  EXPECT_FALSE(answer.garbled);
}

TEST(Transactions, WaitForTheWireTimePlusTheMargin) {
  Line line;
  line.expect(readFrame(1, 0, 44)).silence().expect(readFrame(1, 0, 44)).silence();
  const Nanos began = line.now();
  const Answer answer = readRegisters(line, 1, 0, 44, {2, 5ms});
  EXPECT_EQ(answer.status, LineStatus::kTimeout);
  EXPECT_EQ(line.now() - began, 2 * (wireTime(8 + 50) + 5ms));
}

TEST(Transactions, AnotherDevicesReplyOfEqualLengthIsIgnored) {
  Line line;
  line.expect(kRead).answer(joined(statusFrame(2, {1, 2}), statusFrame(1, {3, 4})));
  const Answer answer = readRegisters(line, 1, 36, 2);
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer.data()[0], 3);
}

TEST(Transactions, AReplyOfAnotherLengthIsIgnored) {
  Line line;
  line.expect(kRead).answer(joined(statusFrame(1, {9}), statusFrame(1, {3, 4})));
  const Answer answer = readRegisters(line, 1, 36, 2);
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer.data()[0], 3);
}

TEST(Transactions, ALateReplyIsNotTakenForTheNextOne) {
  Line line;
  line.expect(kRead).answer(statusFrame(1, {9, 9}), 4ms).expect(kRead).answer(statusFrame(1, {3, 4}));
  const Patience once{1, 2ms};
  EXPECT_EQ(readRegisters(line, 1, 36, 2, once).status, LineStatus::kTimeout);
  line.advanceTo(line.now() + 3ms);
  EXPECT_EQ(readRegisters(line, 1, 36, 2, once).data()[0], 3);
}

TEST(Transactions, FindTheReplyAfterGarbage) {
  Line line;
  line.expect(pingFrame(1)).answer(joined({0x00, 0xFF, 0x41}, statusFrame(1)));
  EXPECT_TRUE(ping(line, 1).ok());
}

TEST(Transactions, DistinguishGarbledFromSilent) {
  Line line;
  Octets damaged = statusFrame(1, {3, 4});
  damaged[5] ^= 0x10;
  line.expect(kRead).answer(damaged).silence();
  const Answer answer = readRegisters(line, 1, 36, 2, {1, 2ms});
  EXPECT_EQ(answer.status, LineStatus::kTimeout);
  EXPECT_TRUE(answer.garbled);
}

TEST(Transactions, NoiseAloneIsGarbled) {
  Line line;
  line.expect(pingFrame(1)).answer(joined({0x55, 0x55}, statusFrame(2))).silence();
  EXPECT_TRUE(ping(line, 1, {1, 2ms}).garbled);
}

TEST(Transactions, APartialReplyIsGarbled) {
  Line line;
  line.expect(pingFrame(1)).answer(Octets{0xFF, 0xFF, 0x01}).silence();
  EXPECT_TRUE(ping(line, 1, {1, 2ms}).garbled);
}

TEST(Transactions, ALostLineIsNotRetried) {
  Line line;
  line.lose();
  const Answer answer = ping(line, 1);
  EXPECT_EQ(answer.status, LineStatus::kLost);
  EXPECT_EQ(answer.tries, 1);
  line.lose();
  EXPECT_EQ(pass(line, 1h), LineStatus::kLost);
}

TEST(Transactions, AWriteIsAcknowledged) {
  Line line;
  const Octets power_on{0xFF, 0xFF, 0xC8, 0x04, 0x03, 0x18, 0x01, 0x17};  // vendor's manual
  line.expect(power_on).answer(statusFrame(kBoardId));
  const std::uint8_t on = 1;
  EXPECT_TRUE(writeRegisters(line, kBoardId, 24, Bytes{&on, 1}).ok());
}

/// Never silent, never makes sense.
class BabblingLine final : public ByteLine {
 public:
  [[nodiscard]] Nanos now() noexcept override { return now_; }
  LineStatus write(std::span<const std::uint8_t>) noexcept override { return LineStatus::kOk; }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos) noexcept override {
    std::ranges::fill(into, std::uint8_t{0xFF});
    count = into.size();
    now_ += wireTime(count);
    return LineStatus::kOk;
  }
  void discardInput() noexcept override {}
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return 0; }

 private:
  Nanos now_{0};
};

TEST(Transactions, EndOnContinuousGarbage) {
  BabblingLine line;
  const Answer answer = ping(line, 1, {2, 10ms});
  EXPECT_EQ(answer.status, LineStatus::kTimeout);
  EXPECT_TRUE(answer.garbled);
  EXPECT_LT(line.now(), 40ms);
}

}  // namespace
}  // namespace darwinop::cm730
