// Each block opens for an effect that acts in it, and for no other.
#include "gap/localize/blocks.hpp"

#include <gmock/gmock.h>

#include "gap/localize/localize_case.hpp"

namespace darwinop::gap {
namespace {

Blocks blocksOf(const Case& given, std::vector<std::size_t> logs = {0, 1, 2}) {
  const Plant& plant = plantOf(given);
  return findBlocks(plant, given, baselineOf(given), logs, simulateRepeats(plant, given, logs, baselineOf(given)));
}

struct HiddenIn {
  Hidden hidden;
  std::optional<Block> block;
  twin::Law law = twin::Law::kVoltageP;
};

std::string nameOf(const testing::TestParamInfo<HiddenIn>& info) {
  const std::string law = info.param.law == twin::Law::kVoltageP ? "VoltageP" : "SpeedP";
  return std::string{info.param.hidden.effect.empty() ? "nothing" : info.param.hidden.effect} + law +
         std::to_string(info.index);
}

class BlockOf : public testing::TestWithParam<HiddenIn> {};

TEST_P(BlockOf, OpensAndTheOthersStayClosed) {
  const Blocks found = blocksOf(measuredCase(GetParam().hidden, GetParam().law));
  EXPECT_EQ(found.first, GetParam().block);
  for (const BlockFinding& one : found.all) {
    if (one.block == GetParam().block)
      EXPECT_EQ(one.verdict, BlockVerdict::kOpen) << name(one.block);
    else
      EXPECT_NE(one.verdict, BlockVerdict::kOpen) << name(one.block) << ": " << one.significance << " " << one.detail;
  }
}

constexpr auto kSpeedP = twin::Law::kSpeedP;
INSTANTIATE_TEST_SUITE_P(
    Effects, BlockOf,
    testing::Values(HiddenIn{{"", {}}, {}}, HiddenIn{{"transport_delay", {0.03, 0}}, Block::kCommand},
                    HiddenIn{{"transport_delay", {0.008, 0}}, Block::kCommand},
                    HiddenIn{{"accel_limit", {60}}, Block::kCommand}, HiddenIn{{"speed_limit", {2.5}}, Block::kCommand},
                    HiddenIn{{"kp_scale", {0.9}}, Block::kController},
                    HiddenIn{{"torque_limit", {0.6, 10}}, Block::kController},
                    HiddenIn{{"gear_scale", {0.97}}, Block::kController},
                    HiddenIn{{"supply_sag", {1, 0}}, Block::kSupply}, HiddenIn{{"coulomb", {0.15}}, Block::kPlant},
                    HiddenIn{{"com_mass", {0.15, 0}}, Block::kPlant},
                    HiddenIn{{"encoder_offset", {0.04}}, Block::kPlant}, HiddenIn{{"backlash", {0.03}}, Block::kPlant}),
    nameOf);
INSTANTIATE_TEST_SUITE_P(LawSpeedP, BlockOf,
                         testing::Values(HiddenIn{{"", {}}, {}, kSpeedP},
                                         HiddenIn{{"speed_limit", {2.5}}, Block::kCommand, kSpeedP},
                                         HiddenIn{{"gear_scale", {0.95}}, Block::kController, kSpeedP},
                                         HiddenIn{{"p_on_torque", {1}}, Block::kController, kSpeedP},
                                         HiddenIn{{"coulomb", {0.2}}, Block::kPlant, kSpeedP}),
                         nameOf);

TEST(Blocks, CloseWhenNumbersAreOffInsideTheirPriors) {
  Case given = measuredCase({"coulomb", {0.088}});  // a sigma more than the baseline says
  EXPECT_FALSE(blocksOf(given).first) << "with a prior of 10 %";
  given.priors = {{"payload", 0.001}};
  EXPECT_EQ(blocksOf(given).first, Block::kPlant) << "without";
}

TEST(Blocks, ReportTheControllersErrorInTicks) {
  const BlockFinding quiet = blocksOf(measuredCase({})).of(Block::kController);
  EXPECT_EQ(quiet.unit, "ticks");
  EXPECT_GT(quiet.rms, 0.3);  // rounding and noise of the encoder are there
  EXPECT_LT(quiet.rms, 2);
  EXPECT_NEAR(quiet.expected_rms, quiet.rms, 0.2 * quiet.rms);
}

TEST(Blocks, MeasureTheResistanceOfTheSupply) {
  const Blocks found = blocksOf(measuredCase({"supply_sag", {1, 0}}));
  EXPECT_NEAR(found.supply_ohm, 1, 0.2);
  EXPECT_LT(found.supply_ohm_sigma, 0.1);
}

// The current is computed from the motor's numbers: a sag cannot be known better than these.
TEST(Blocks, MeasureASupplyAsWellAsTheMotorIsKnown) {
  Case given = measuredCase({"supply_sag", {1, 0}});
  const double exact = blocksOf(given).supply_ohm_sigma;
  given.priors.push_back({"resistance", 0.2});
  const Blocks found = blocksOf(given);
  EXPECT_GT(found.supply_ohm_sigma, 3 * exact);
  given.model.servo.resistance_ohm *= 0.8;
  const Blocks wrong = blocksOf(given);
  EXPECT_GT(std::abs(wrong.supply_ohm - 1), 0.1) << "the motor is off by a sigma";
  EXPECT_LT(std::abs(wrong.supply_ohm - 1), 2 * wrong.supply_ohm_sigma);
}

TEST(Blocks, DetectASpeedThatContradictsThePositions) {
  Case given = measuredCase({});
  for (Trajectory& log : given.logs)
    for (double& speed : log.speed_rad_s) speed *= 2;
  EXPECT_EQ(blocksOf(given).first, Block::kSensor);
}

TEST(Blocks, ReportBlocksThatCannotBeSeparated) {
  Case given = measuredCase({});
  for (Trajectory& log : given.logs) {
    std::ranges::fill(log.load, std::nan(""));
    std::ranges::fill(log.volt_v, std::nan(""));
    std::ranges::fill(log.speed_rad_s, std::nan(""));
  }
  const Blocks found = blocksOf(given);
  for (const Block block : {Block::kCommand, Block::kController, Block::kSupply, Block::kSensor}) {
    EXPECT_EQ(found.of(block).verdict, BlockVerdict::kNotTestable) << name(block);
    EXPECT_THAT(found.of(block).detail, testing::HasSubstr("no ")) << name(block);
    EXPECT_TRUE(std::isnan(found.of(block).rms)) << "missing is not 0";
  }
  EXPECT_EQ(found.of(Block::kPlant).verdict, BlockVerdict::kClosed);

  const Blocks always_on = blocksOf(measuredCase({}, twin::Law::kSpeedP), {0, 1});
  EXPECT_EQ(always_on.of(Block::kPlant).verdict, BlockVerdict::kNotTestable);
  EXPECT_EQ(always_on.of(Block::kPlant).detail, kPlantNeedsTorqueOff);
}

TEST(Blocks, AreRankedByHowFarTheyMoveTheJoint) {
  // A sag of a tenth of a volt, which the voltage shows clearly, beside a friction that moves the arm ten times as far.
  Case given = measuredCase({"coulomb", {0.2}});
  for (Trajectory& log : given.logs)
    for (double& volt : log.volt_v) volt -= 0.1;
  const Blocks found = blocksOf(given);
  EXPECT_EQ(found.of(Block::kSupply).verdict, BlockVerdict::kOpen);
  EXPECT_EQ(found.of(Block::kPlant).verdict, BlockVerdict::kOpen);
  EXPECT_EQ(found.first, Block::kPlant);
  EXPECT_GT(found.of(Block::kPlant).share, 0.9);
  EXPECT_NEAR(found.of(Block::kPlant).share + found.of(Block::kSupply).share, 1, 1e-9);
  EXPECT_EQ(found.of(Block::kController).share, 0) << "closed";
}

}  // namespace
}  // namespace darwinop::gap
