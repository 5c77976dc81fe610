// Robots whose inertial sensor cannot be calibrated.
#include "apps/calibrate/imu_procedure.hpp"

#include <gmock/gmock.h>

#include <sstream>
#include <stdexcept>

#include "apps/calibrate/messages.hpp"

namespace darwinop::calibrate {
namespace {

/// Servos alone on an adapter.
struct ServosAlone final : runtime::RobotLink {
  [[nodiscard]] Nanos period() const override { return std::chrono::milliseconds{16}; }
  [[nodiscard]] Nanos now() const override { return {}; }
  [[nodiscard]] bool realTime() const override { return false; }
  void publish(Commands) override {}
  bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>&) override {
    seen.cycle = cycle;
    seen.board.absent = true;
    return true;
  }
  [[nodiscard]] Sensors sensors() const override { return seen; }
  [[nodiscard]] std::string whyEnded() const override { return {}; }
  Sensors seen;
};

TEST(ImuProcedure, ARobotWithoutABoardIsRefusedBeforeAnyoneLiftsIt) {
  ServosAlone link;
  std::istringstream answers{"\n\n\n\n\n\n"};
  std::ostringstream instructions, log;
  OwnersHands hands{answers, instructions};
  const std::atomic<bool> running{false};
  try {
    (void)readPostures(link, hands, {}, std::chrono::seconds{1}, running, log);
    FAIL() << "it was calibrated";
  } catch (const std::runtime_error& refused) {
    EXPECT_STREQ(refused.what(), messages::kNoImu);
  }
  EXPECT_TRUE(instructions.str().empty());
}

}  // namespace
}  // namespace darwinop::calibrate
