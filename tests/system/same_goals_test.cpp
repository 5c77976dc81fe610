// One controller, unchanged, on every kind of robot: the same goals for all joints in every cycle.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "system/rig.hpp"

namespace darwinop {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::Gt;

/// Over TCP goals travel in whole servo ticks, and a page or a walk starts at such a goal. No other goal differs.
constexpr double kTcpTolerance = kRadPerTick;
/// In real time the newest image wins: of two that a delayed controller offers within a cycle, the first is never sent,
/// and where that makes a joint leap, safety limits its speed. That is allowed for one row in ten.
constexpr double kDelayed = 0.1;

/// rad, of all joints in one cycle.
using GoalRow = std::array<double, kJoints>;

/// The goals of one session while it drove all joints, by cycle.
struct Goals {
  std::vector<GoalRow> asked, commanded;
};

/// By session, in order.
std::vector<Goals> goalsIn(const std::string& recording) {
  constexpr double kDriven = 4;  // safety.state
  const Recording log{recording};
  std::vector<Goals> sessions;
  double session = 0;
  for (std::size_t i = 0; i < log.rows(); ++i) {
    if (log.at(i, "safety.state") != kDriven || log.at(i, "driver.session") == 0) continue;
    if (sessions.empty() || session != log.at(i, "driver.session")) sessions.emplace_back();
    session = log.at(i, "driver.session");
    GoalRow asked{}, commanded{};
    for (std::size_t j = 0; j < kJoints; ++j) {
      const std::string joint{kJointTable[j].name};
      asked[j] = log.at(i, joint + ".asked [rad]");
      commanded[j] = log.at(i, joint + ".commanded [rad]");
    }
    const auto is_missing = [](double goal) { return std::isnan(goal); };
    if (std::ranges::none_of(asked, is_missing)) sessions.back().asked.push_back(asked);
    if (std::ranges::none_of(commanded, is_missing)) sessions.back().commanded.push_back(commanded);
  }
  return sessions;
}

/// In simulated time: every row.
void expectEqual(const std::vector<GoalRow>& rows, const std::vector<GoalRow>& reference) {
  ASSERT_EQ(rows.size(), reference.size());
  for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_EQ(rows[i], reference[i]) << "row " << i;
}

/// In real time, by order: `tolerance` in rad.
struct Match {
  Match(const std::vector<GoalRow>& rows, const std::vector<GoalRow>& reference, double tolerance) {
    const auto is_near = [&](const GoalRow& a, const GoalRow& b) {
      return std::ranges::equal(a, b, [&](double x, double y) { return std::abs(x - y) <= tolerance; });
    };
    std::size_t at = 0, counted = 0;
    for (const GoalRow& row : rows) {
      std::size_t found = at;
      while (found < reference.size() && !is_near(reference[found], row)) ++found;
      if (found == reference.size()) {
        ++unknown;
        continue;
      }
      at = found;
      for (found = std::max(at, counted); found < reference.size() && is_near(reference[found], row); ++found) ++sent;
      counted = std::max(counted, found);
    }
  }
  std::size_t unknown = 0;  // rows that the reference does not have, or has earlier
  std::size_t sent = 0;     // rows of the reference that were found
};

void expectInOrder(const Goals& goals, const Goals& reference, double tolerance) {
  const auto share = [](double of, const std::vector<GoalRow>& rows) { return of * static_cast<double>(rows.size()); };
  const Match asked{goals.asked, reference.asked, tolerance};
  EXPECT_EQ(asked.unknown, 0U) << "of " << goals.asked.size();
  EXPECT_GE(asked.sent, share(1 - kDelayed, reference.asked)) << "of " << reference.asked.size();
  const Match commanded{goals.commanded, reference.commanded, tolerance};
  EXPECT_LE(commanded.unknown, share(kDelayed, goals.commanded)) << "of " << goals.commanded.size();
  EXPECT_GE(commanded.sent, share(1 - kDelayed, reference.commanded)) << "of " << reference.commanded.size();
}

class SameGoals : public Rig {
 protected:
  /// The check at the start may find a cycle too long on a busy machine. The daemon waits; a controller with a port of
  /// its own ends before it drives, and is started again.
  std::vector<Goals> recordedOnThePort() {
    const std::string recording = file("port.csv");
    for (int i = 0; i < 20 && !std::filesystem::exists(recording); ++i) {
      Program running{{program("darwinop-run"), "--robot", port(), "--record", recording, controller()},
                      file("run.txt")};
      const auto status = running.wait(seconds{90});
      EXPECT_TRUE(status == 0 || !std::filesystem::exists(recording)) << running.output();
    }
    return goalsIn(recording);
  }
};

TEST_F(SameGoals, OfAllJointsOnTheVirtualRobotTheTwinASerialPortTheDaemonAndOverTcp) {
  run("virtual", {"--record", file("virtual.csv")}, {});
  const std::vector<Goals> recorded = goalsIn(file("virtual.csv"));
  ASSERT_EQ(recorded.size(), 1U);
  const Goals& reference = recorded[0];
  ASSERT_THAT((std::array{reference.asked.size(), reference.commanded.size()}), ElementsAre(Gt(300U), Gt(300U)));
  for (std::size_t j = 0; j < kJoints; ++j)
    EXPECT_TRUE(std::ranges::any_of(
        reference.commanded,
        [&](const GoalRow& row) { return std::abs(row[j] - reference.commanded[0][j]) > 10 * kTcpTolerance; }))
        << kJointTable[j].name << " is not moved";

#ifdef DARWINOP_WITH_TWIN
  {
    const testing::ScopedTrace trace{__FILE__, __LINE__, "twin"};
    run("twin", {"--record", file("twin.csv")}, {});
    const std::vector<Goals> twin = goalsIn(file("twin.csv"));
    ASSERT_EQ(twin.size(), 1U);
    expectEqual(twin[0].asked, reference.asked);
    expectEqual(twin[0].commanded, reference.commanded);
  }
#endif

  startVirtualRobot();
  const std::vector<Goals> embedded = recordedOnThePort();
  Program daemon{{program("darwinop-runtime"), "--wait", "--robot", port(), "--record", file("daemon.csv")},
                 file("daemon.txt")};
  ASSERT_TRUE(daemon.says("ready:", seconds{20})) << daemon.output();
  run("runtime", {}, {});
  {
    Program server{{program("darwinop-remote"), "--robot", "runtime", "--port", "0"}, file("remote.txt")};
    const std::string ready = "ready: ";
    ASSERT_TRUE(server.says(ready, seconds{20})) << server.output();
    const std::string said = server.output();
    const std::size_t address = said.find(ready) + ready.size();
    run("tcp://" + said.substr(address, said.find('\n', address) - address), {}, {});
    server.kill(SIGTERM);
    EXPECT_EQ(server.wait(seconds{20}), 0) << server.output();
  }
  daemon.kill(SIGTERM);
  ASSERT_EQ(daemon.wait(seconds{20}), 0) << daemon.output();

  const std::vector<Goals> through_daemon = goalsIn(file("daemon.csv"));
  ASSERT_EQ(embedded.size(), 1U);
  ASSERT_EQ(through_daemon.size(), 2U);
  const auto expect = [&](const char* way, const Goals& goals, double tolerance) {
    const testing::ScopedTrace trace{__FILE__, __LINE__, way};
    expectInOrder(goals, reference, tolerance);
  };
  expect("pty", embedded[0], 0);
  expect("daemon", through_daemon[0], 0);
  expect("tcp", through_daemon[1], kTcpTolerance);
}

}  // namespace
}  // namespace darwinop
