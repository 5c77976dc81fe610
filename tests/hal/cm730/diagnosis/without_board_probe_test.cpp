// The start-up probe on servos alone.
#include <gmock/gmock.h>

#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/fault_naming.hpp"
#include "hal/cm730/diagnosis/probe_bench.hpp"
#include "hal/cm730/diagnosis/rows.hpp"
#include "hil-mocks/robot_options.hpp"

namespace darwinop::cm730 {
namespace {

using testing::HasSubstr;

struct ProbeWithoutBoard : testing::Test {
  ProbeReport probe(ProbeOptions options = ProbeOptions::quick(), bool permitted = true) {
    options.permitted.no_board = permitted;
    hil::VirtualRobot robot{board};
    hil::MemoryLine line{robot};
    return cm730::probe(line, options);
  }
  static hil::BoardOptions alone() {
    hil::BoardOptions options;
    options.board = false;
    return options;
  }
  hil::BoardOptions board = alone();
};

TEST_F(ProbeWithoutBoard, HealthyServosAreDrivenWithoutAFinding) {
  for (const ProbeOptions& options : {ProbeOptions::quick(), ProbeOptions::thorough()}) {
    const ProbeReport report = probe(options);
    EXPECT_TRUE(report.facts.board.absent);
    EXPECT_EQ(decide(report.findings, Purpose::kDrive), Policy::kDrive);
    for (const Finding& row : report.findings) EXPECT_EQ(row.level, Level::kOk) << row.what;
    EXPECT_TRUE(nameFaults(report.facts, report.findings).empty());
    EXPECT_TRUE(report.facts.instructions.bulk_read && report.facts.instructions.sync_write);
    EXPECT_TRUE(report.facts.instructions.all_blocks);
    EXPECT_GT(report.facts.round_trip.reads, 0);
  }
}

TEST_F(ProbeWithoutBoard, NothingIsDrivenThatNobodyPermitted) {
  const ProbeReport report = probe(ProbeOptions::quick(), false);
  EXPECT_FALSE(report.facts.board.absent);
  EXPECT_EQ(decide(report.findings, Purpose::kDrive), Policy::kWait);
  EXPECT_THAT(rowOf(report.findings, Kind::kNoBoard).remedy, HasSubstr("[Robot] board = none"));
}

TEST_F(ProbeWithoutBoard, ABoardIsRefusedBeforeAnythingIsWritten) {
  board = hil::BoardOptions{};
  const ProbeReport report = probe();
  EXPECT_EQ(decide(report.findings, Purpose::kDrive), Policy::kRefuse);
  EXPECT_EQ(decide(report.findings, Purpose::kRescue), Policy::kRefuse);
  EXPECT_EQ(rowOf(report.findings, Kind::kBoardNotExpected).level, Level::kError);
  EXPECT_FALSE(report.facts.board.power_on);
}

TEST_F(ProbeWithoutBoard, TheSupplyIsThatOfTheServos) {
  board.supply_v = 9.7;
  const ProbeReport report = probe();
  EXPECT_EQ(decide(report.findings, Purpose::kDrive), Policy::kRest);
  EXPECT_THAT(rowOf(report.findings, Kind::kSupplyEmpty).what, HasSubstr("9.7 V"));
}

TEST_F(ProbeWithoutBoard, ServosWithoutBulkReadOrSyncWriteAreRefused) {
  board.bulk_read = false;
  EXPECT_EQ(rowOf(probe().findings, Kind::kNoBulkRead).level, Level::kError);
  board.bulk_read = true;
  board.sync_write = false;
  EXPECT_EQ(rowOf(probe().findings, Kind::kNoSyncWrite).level, Level::kError);
}

TEST_F(ProbeWithoutBoard, ASilentServoAtTheHeadOfTheListHidesNoOther) {
  hil::setServo(board, "ShoulderR=missing");
  const ProbeReport report = probe();
  EXPECT_EQ(report.facts.instructions.all_blocks, true);
  for (std::size_t i = 1; i < kJoints; ++i) EXPECT_TRUE(report.facts.servo[i].bulk_read_works) << i;
  EXPECT_EQ(decide(report.findings, Purpose::kDrive), Policy::kNoWrites);
}

}  // namespace
}  // namespace darwinop::cm730
