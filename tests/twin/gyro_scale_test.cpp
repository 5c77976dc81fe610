// A turn at a known rate, seen by everything that shows the gyroscope: there is one scale between rad/s and counts.
#include <nlohmann/json.hpp>

#include "connect/lockstep_robot.hpp"
#include "core/counts.hpp"
#include "core/registers.hpp"
#include "experiments/logs/read_log.hpp"
#include "monitor/messages.hpp"
#include "support/temporary_folder.hpp"
#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

constexpr double kHalfACount = 0.5 * kGyroRegister.scale;
constexpr std::size_t kUp = 2;  // axis of the gyroscope

struct Turn {
  double twin, link, recording, monitor;  // rad/s
  double count;
};

/// What each shows of a robot that hangs in the air and turns to the left.
Turn seenAt(double rate_rad_s) {
  const TemporaryFolder folder;
  runtime::LoopConfig config;
  config.record_path = folder / "turn.csv";
  auto owned = std::make_unique<RobotBody>(modelWith(50), RobotBodyOptions{.ball = Ball::kNone});
  RobotBody& body = *owned;
  hangUp(body);
  trunkQvel(body)[4] = rate_rad_s;
  Turn seen{};
  {
    const std::unique_ptr<runtime::RobotLink> link = connect::lockstepRobot(config, std::move(owned));
    const std::atomic<bool> stop{false};
    for (std::uint64_t cycle = 1; cycle <= 3; ++cycle) EXPECT_TRUE(link->waitForCycle(cycle, stop));
    const Sensors sensors = link->sensors();
    EXPECT_TRUE(sensors.board.motion.fresh());
    seen.twin = body.state().gyro_rad_s[kUp];
    seen.link = sensors.board.gyro[kUp].value;
    seen.count = countFrom(seen.link, kGyroRegister);
    const auto text = nlohmann::json::parse(monitor::stateText(sensors));
    seen.monitor = text["board"]["gyro"][kUp].get<double>();
    EXPECT_EQ(text["board"]["gyro_count"][kUp].get<double>(), seen.count);
  }
  const logs::Log log = logs::readLog(config.record_path);
  seen.recording = log.column("gyro.z").values.back();
  return seen;
}

TEST(GyroScale, ATurnHasTheSameRateInTwinRecordingMonitorAndApi) {
  for (const double rate : {-30.0, -3.0, 1.0, 12.0, 30.0}) {
    const Turn seen = seenAt(rate);
    EXPECT_NEAR(seen.twin, rate, 0.01) << rate;
    EXPECT_NEAR(seen.link, rate, kHalfACount + 0.01) << rate;
    EXPECT_NEAR(seen.recording, rate, kHalfACount + 0.01) << rate;
    EXPECT_NEAR(seen.monitor, seen.link, 1e-3) << rate;
    EXPECT_EQ(seen.count, std::round(512 + seen.twin / kGyroRegister.scale)) << rate;
  }
}

TEST(GyroScale, ACountIsTheFirmwares) {
  EXPECT_NEAR(kGyroRegister.scale / kRadPerDegree, 3.584, 1e-9);
}

}  // namespace
}  // namespace darwinop::twin::test
