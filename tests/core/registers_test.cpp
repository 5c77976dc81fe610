// The control tables: consistent in themselves, with the conversions, and with the windows of a cycle.
#include "core/registers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "core/conversions.hpp"

namespace darwinop {
namespace {

class Table : public testing::TestWithParam<std::span<const Register>> {};

TEST_P(Table, FitsItsMemory) {
  const auto size = GetParam().data() == kCm730.data() ? kBoardTableSize : kServoTableSize;
  for (const Register& r : GetParam()) {
    EXPECT_TRUE(r.bytes == 1 || r.bytes == 2) << r.name;
    EXPECT_LE(r.address + std::size_t{r.bytes}, size) << r.name;
  }
}

TEST_P(Table, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const Register& r : GetParam()) EXPECT_TRUE(names.insert(r.name).second) << r.name;
}

TEST_P(Table, ResetValueIsAllowedAndRangeFitsTheWidth) {
  for (const Register& r : GetParam()) {
    EXPECT_LE(r.low, r.high) << r.name;
    EXPECT_LE(r.high, r.bytes == 1 ? 255 : 65535) << r.name;
    EXPECT_GE(r.reset, r.low) << r.name;
    EXPECT_LE(r.reset, r.high) << r.name;
  }
}

TEST_P(Table, ScaleIsUsableAndAnythingScaledHasAUnit) {
  for (const Register& r : GetParam()) {
    EXPECT_GT(r.scale, 0) << r.name;
    const bool gain = r.name.ends_with("_gain");  // P, I, D are numbers by the vendor's definition
    EXPECT_TRUE(r.scale == 1 || gain || !r.unit.empty()) << r.name;
  }
}

std::string nameOf(const testing::TestParamInfo<std::span<const Register>>& table) {
  constexpr std::array kNames{"Cm730", "Mx28", "StrongerMx"};
  return kNames[table.index];
}
INSTANTIATE_TEST_SUITE_P(Registers, Table, testing::Values(std::span{kCm730}, std::span{kMx28}, std::span{kStrongerMx}),
                         nameOf);

double toSi(const Register& r, double raw) {
  return (raw - r.zero) * r.scale;
}

TEST(Registers, ScalesAgreeWithTheConversions) {
  constexpr auto position = find(kMx28, "present_position"), goal = find(kMx28, "goal_position");
  constexpr auto speed = find(kMx28, "present_speed"), torque = find(kMx28, "torque_limit");
  constexpr auto load = find(kMx28, "present_load"), voltage = find(kMx28, "present_voltage");
  for (const int raw : {0, 1, 500, 1023}) {
    const auto word = static_cast<std::uint16_t>(raw);
    EXPECT_DOUBLE_EQ(toSi(position, raw), radFromTicks(raw).value);
    EXPECT_DOUBLE_EQ(toSi(goal, raw), radFromTicks(raw).value);
    EXPECT_DOUBLE_EQ(toSi(speed, raw), velocityFromRegister(word).value);
    EXPECT_DOUBLE_EQ(toSi(torque, raw), torqueFromRegister(word).value);
    EXPECT_DOUBLE_EQ(toSi(load, raw), loadFromRegister(word));
  }
  EXPECT_DOUBLE_EQ(toSi(voltage, 118), voltFromRegister(118).value);
}

TEST(Registers, UprightRobotAtRestMeasuresOneGravityAndNoRotation) {
  EXPECT_DOUBLE_EQ(toSi(find(kCm730, "accel_z"), 640), 9.80665);
  EXPECT_DOUBLE_EQ(toSi(find(kCm730, "accel_x"), 512), 0);
  EXPECT_DOUBLE_EQ(toSi(find(kCm730, "gyro_x"), 512), 0);
}

TEST(Registers, OneGyroCountIs3Point584DegreesPerSecond) {
  EXPECT_NEAR(find(kCm730, "gyro_z").scale / kRadPerDegree, 3.584, 1e-9);
}

TEST(Registers, GyroOrderIsZYXAndAccelerometerOrderIsXYZ) {
  EXPECT_EQ(find(kCm730, "gyro_z").address, 38);
  EXPECT_EQ(find(kCm730, "gyro_y").address, 40);
  EXPECT_EQ(find(kCm730, "gyro_x").address, 42);
  EXPECT_EQ(find(kCm730, "accel_x").address, 44);
  EXPECT_EQ(find(kCm730, "accel_y").address, 46);
  EXPECT_EQ(find(kCm730, "accel_z").address, 48);
}

TEST(Registers, OneSyncWriteSpansGainGoalSpeedAndTorqueLimit) {
  EXPECT_EQ(servo::kPGain, 28);
  EXPECT_EQ(servo::kGoalPosition, 30);
  EXPECT_EQ(servo::kMovingSpeed, 32);
  EXPECT_EQ(servo::kTorqueLimit, 34);
  int writable = 0;
  for (const Register& r : kMx28)
    if (r.address >= 28 && r.address < 36 && r.access == Access::kReadWrite) writable += r.bytes;
  EXPECT_EQ(writable, 8);  // no hole, nothing read-only: the servo would refuse the whole write
}

TEST(Registers, ShutdownMaskAndAlarmLedAreSettingsNotAlarms) {
  EXPECT_EQ(find(kMx28, "shutdown").address, 18);
  EXPECT_EQ(find(kMx28, "shutdown").memory, Memory::kEeprom);
  EXPECT_EQ(find(kMx28, "shutdown").reset, 4 + 32);  // overheating and overload
}

}  // namespace
}  // namespace darwinop
