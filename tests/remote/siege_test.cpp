// Attacks on the remote-control port with real daemon and server: the driving client is served, the loop runs, memory
// is bounded. A benchmark measures the loop's wake-up latency under attack.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "attackers.hpp"
#include "siege_rig.hpp"

namespace darwinop::remote {
namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t kCyclesOfAnAttack = 60;
constexpr long kMayGrowKb = 32 * 1024;  // the address sanitizer retains freed memory

/// Connects as a simulator does: retries until it is accepted.
bool driven(std::uint16_t port) {
  for (int i = 0; i < 300; ++i) {
    if (SiegeClient{port}.ask()) return true;
    std::this_thread::sleep_for(20ms);
  }
  return false;
}

class RemoteSiege : public testing::Test {
 protected:
  /// The loop has run and every reply of the robot was complete.
  void expectRobotUnharmed(const runtime::StatsView& before) const {
    const runtime::StatsView now = rig_.stats().since(before);
    EXPECT_GE(now.cycles, kCyclesOfAnAttack);
    EXPECT_EQ(now.reconnects, 0);
  }
  static long lines(const std::string& text) { return std::ranges::count(text, '\n'); }

  SiegeRig rig_{DARWINOP_BIN};
};

TEST_F(RemoteSiege, TheDrivingClientIsServedDuringEveryAttack) {
  const SiegeClient driver{rig_.port()};
  ASSERT_TRUE(driver.ask());
  for (const Attack attack : kAttacks) {
    const runtime::StatsView before = rig_.stats();
    const Attacker attacker{attack, rig_.port()};
    while (rig_.stats().since(before).cycles < kCyclesOfAnAttack) {
      ASSERT_TRUE(driver.ask()) << nameOf(attack) << ": " << rig_.server().output();
      std::this_thread::sleep_for(5ms);
    }
    EXPECT_EQ(attacker.connected(), 0) << nameOf(attack) << ": the door is closed while one drives";
    expectRobotUnharmed(before);
  }
  EXPECT_THAT(rig_.server().output(), testing::Not(testing::HasSubstr("silent")));
}

TEST_F(RemoteSiege, TheServerRecoversAfterAnAttack) {
  ASSERT_TRUE(driven(rig_.port()));
  const long resident = rig_.residentKb();
  for (const Attack attack : kAttacks) {
    const runtime::StatsView before = rig_.stats();
    {
      const Attacker first{attack, rig_.port()}, second{attack, rig_.port()};
      ASSERT_TRUE(rig_.runCycles(kCyclesOfAnAttack)) << nameOf(attack) << ": " << rig_.runtime().output();
      EXPECT_GT(first.connected() + second.connected(), 0) << nameOf(attack) << " has reached no server";
    }
    expectRobotUnharmed(before);
    EXPECT_TRUE(driven(rig_.port())) << nameOf(attack) << ": " << rig_.server().output();
  }
  EXPECT_LT(rig_.residentKb(), resident + kMayGrowKb);
  EXPECT_LE(lines(rig_.server().output()), 100) << "30 lines a minute for any number of clients";
  rig_.server().kill(SIGTERM);
  EXPECT_EQ(rig_.server().wait(20s), 0) << rig_.server().output();
}

// Each client is logged, each time with the settings of config.ini that a daemon does not apply.
TEST(RemoteSiegeLog, IsBoundedWithAConfigIni) {
  SiegeRig rig{DARWINOP_BIN, {}, "[Safety]\nstall_ms = 400\n"};
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(driven(rig.port())) << i;
  const std::string said = rig.server().output();
  EXPECT_LE(std::ranges::count(said, '\n'), 70) << "30 lines a minute, and this takes less than two";
}

}  // namespace
}  // namespace darwinop::remote
