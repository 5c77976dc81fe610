// SerialPort on a real pty.
#include "hal/cm730/serial_port.hpp"

#include <gtest/gtest.h>
#include <termios.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <optional>
#include <thread>

#include "hal/cm730/pty.hpp"
#include "hal/cm730/serial_open.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop::cm730 {
namespace {

using namespace std::chrono_literals;

constexpr std::array<std::uint8_t, 5> kBytes{0xFF, 0xFF, 0x0D, 0x0A,
                                             0x03};  // bytes that a cooked terminal would change

Nanos threadCpuTime() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds{time.tv_sec} + Nanos{time.tv_nsec};
}

TEST(SerialPort, CarriesBytesUnchangedBothWays) {
  Pty pty;
  SerialPort port{pty.path()};
  EXPECT_EQ(port.write(kBytes), LineStatus::kOk);
  EXPECT_EQ(receive(pty, kBytes.size()), std::vector<std::uint8_t>(kBytes.begin(), kBytes.end()));

  send(pty, kBytes);
  std::array<std::uint8_t, 64> into{};
  std::size_t count = 0;
  EXPECT_EQ(port.read(into, count, port.now() + 1s), LineStatus::kOk);
  ASSERT_EQ(count, kBytes.size());
  EXPECT_TRUE(std::equal(kBytes.begin(), kBytes.end(), into.begin()));
}

TEST(SerialPort, WaitsUntilTheDeadlineWithoutUsingCpu) {
  Pty pty;
  SerialPort port{pty.path()};
  std::array<std::uint8_t, 8> into{};
  std::size_t count = 99;
  const Nanos began = port.now(), cpu_began = threadCpuTime();
  EXPECT_EQ(port.read(into, count, began + 80ms), LineStatus::kTimeout);
  EXPECT_EQ(count, 0u);
  EXPECT_GE(port.now() - began, 80ms);
  EXPECT_LT(threadCpuTime() - cpu_began, 10ms) << "busy loop";
}

TEST(SerialPort, ReturnsAvailableBytesEvenAfterTheDeadline) {
  Pty pty;
  SerialPort port{pty.path()};
  send(pty, kBytes);
  std::array<std::uint8_t, 8> into{};
  std::size_t count = 0;
  EXPECT_EQ(port.read(into, count, port.now() + 1s), LineStatus::kOk);
  send(pty, kBytes);
  ASSERT_EQ(::tcdrain(pty.fd()), 0);
  LineStatus status = LineStatus::kTimeout;
  for (int i = 0; i < 10'000 && status == LineStatus::kTimeout; ++i) status = port.read(into, count, Nanos{0});
  EXPECT_EQ(status, LineStatus::kOk);
}

TEST(SerialPort, WakesWhenBytesArrive) {
  Pty pty;
  SerialPort port{pty.path()};
  std::array<std::uint8_t, 8> into{};
  std::size_t count = 0;
  std::thread sender{[&] { send(pty, kBytes); }};
  EXPECT_EQ(port.read(into, count, port.now() + 10s), LineStatus::kOk);
  EXPECT_GE(count, 1u);
  sender.join();
}

TEST(SerialPort, IsLostWhenTheOtherEndClosesDuringAWait) {
  std::optional<Pty> pty{std::in_place};
  SerialPort port{pty->path()};
  std::array<std::uint8_t, 8> into{};
  std::size_t count = 0;
  std::thread closer{[&] { pty.reset(); }};
  const Nanos began = port.now();
  EXPECT_EQ(port.read(into, count, began + 10s), LineStatus::kLost);
  EXPECT_LT(port.now() - began, 5s);
  closer.join();
}

TEST(SerialPort, IsLostAtTheNextWriteAndFailsAtOnceAfterwards) {
  std::optional<Pty> pty{std::in_place};
  SerialPort port{pty->path()};
  pty.reset();
  EXPECT_EQ(port.write(kBytes), LineStatus::kLost);
  std::array<std::uint8_t, 8> into{};
  std::size_t count = 0;
  const Nanos began = port.now();
  EXPECT_EQ(port.read(into, count, began + 10s), LineStatus::kLost);
  EXPECT_LT(port.now() - began, 5s);
  port.discardInput();
  EXPECT_EQ(port.reconnects(), 0u);
}

TEST(SerialPort, ReconnectsThroughARecreatedLink) {
  const TemporaryFolder folder;
  const std::string link = folder / "robot";
  std::optional<Pty> pty{link};
  SerialPort port{link};
  pty.reset();
  EXPECT_EQ(port.write(kBytes), LineStatus::kLost);

  Pty after{link};
  const Nanos limit = port.now() + 10s;
  while (port.write(kBytes) == LineStatus::kLost && port.now() < limit) std::this_thread::yield();
  EXPECT_EQ(port.reconnects(), 1u);
  EXPECT_EQ(receive(after, kBytes.size()), std::vector<std::uint8_t>(kBytes.begin(), kBytes.end()));
}

std::size_t openFiles() {
  const std::filesystem::directory_iterator files{"/proc/self/fd"};
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST(SerialPort, LeavesNoDescriptorOpenWhenItReconnects) {
  const TemporaryFolder folder;
  const std::string link = folder / "robot";
  std::optional<Pty> pty{link};
  SerialPort port{link};
  const std::size_t before = openFiles();
  for (std::uint32_t i = 1; i <= 50; ++i) {
    pty.reset();
    pty.emplace(link);
    const Nanos limit = port.now() + 10s;
    while (port.reconnects() < i && port.now() < limit) {
      (void)port.write(kBytes);
      std::this_thread::yield();
    }
    ASSERT_EQ(port.reconnects(), i);
  }
  EXPECT_EQ(openFiles(), before);
}

TEST(SerialPort, AbortsAWriteThatIsNotRead) {
  Pty pty;
  SerialPort port{pty.path()};
  const std::array<std::uint8_t, 4096> much{};
  LineStatus status = LineStatus::kOk;
  Nanos longest{0};
  for (int i = 0; i < 1000 && status == LineStatus::kOk; ++i) {
    const Nanos began = port.now();
    status = port.write(much);
    longest = port.now() - began;
  }
  EXPECT_EQ(status, LineStatus::kTimeout);
  EXPECT_LT(longest, 2s);
}

TEST(SerialPort, DiscardsStaleInput) {
  Pty pty;
  SerialPort port{pty.path()};
  std::array<std::uint8_t, 1> into{};
  std::size_t count = 0;
  send(pty, kBytes);
  ASSERT_EQ(port.read(into, count, port.now() + 1s), LineStatus::kOk);  // the rest has also arrived
  port.discardInput();
  EXPECT_EQ(port.read(into, count, Nanos{0}), LineStatus::kTimeout);
}

TEST(SerialPort, ThrowsAnErrorWithARemedyWithoutAPort) {
  try {
    const SerialPort port{"/dev/ttyNOSUCHPORT"};
    FAIL() << "the port was opened";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string{error.what()}.find(std::string{"/dev/ttyNOSUCHPORT"} + kNoSuchPort), std::string::npos);
  }
}

TEST(SerialPort, AllocatesNothingInUseNorWhenItIsLost) {
  std::optional<Pty> pty{std::in_place};
  SerialPort port{pty->path()};
  send(*pty, kBytes);
  std::array<std::uint8_t, 8> into{};
  std::size_t count = 0;
  const long before = allocationsOfThisThread();
  EXPECT_EQ(port.write(kBytes), LineStatus::kOk);
  EXPECT_EQ(port.read(into, count, port.now() + 1s), LineStatus::kOk);
  EXPECT_EQ(port.read(into, count, port.now() + 1ms), LineStatus::kTimeout);
  port.discardInput();
  pty.reset();
  EXPECT_EQ(port.read(into, count, port.now() + 1s), LineStatus::kLost);
  EXPECT_EQ(port.write(kBytes), LineStatus::kLost);
  EXPECT_EQ(allocationsOfThisThread() - before, 0);
}

}  // namespace
}  // namespace darwinop::cm730
