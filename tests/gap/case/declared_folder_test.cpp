// What is declared of a folder of raw logs.
#include <gmock/gmock.h>

#include <algorithm>
#include <utility>

#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/raw_folder_rig.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr const char* kUnknownMotor = "\"kp\": 32, \"motor\": \"erob80\"";

struct DeclaredFolder : RawFolderTest {};

TEST_F(DeclaredFolder, AVerticalAxisIsDeclared) {
  write(folder / "a.csv", csvOf(sineRows()));
  const FolderCase usable =
      readRawFolder({.folder = folder / "",
                     .model = out / "model.ini",
                     .declared = {"kp=32", "payload_kg=0.3", "length_m=0.17", "supply_V=12", "axis=vertical"},
                     .held_out = {}});
  EXPECT_EQ(usable.given.pendulum.gravity_m_s2, 0);
  EXPECT_EQ(usable.given.pendulum.length_m, 0.17);
}

TEST_F(DeclaredFolder, WhatIsDeclaredOfBamLogsCounts) {
  addLog("a", 8, "0.5");
  const auto declaring = [&](std::vector<std::string> words) {
    return readRawFolder({.folder = folder / "", .model = "", .declared = std::move(words), .held_out = {}}).given;
  };
  const Case plain = declaring({});
  const Case read = declaring({"kt_Nm_A_rel_sigma=0.02", "arm_mass_kg_rel_sigma=0.3", "hangs_at_rad=0.05",
                               "goal_order=after_read", "axis=vertical", "from_s=0.1", "to_s=2.2"});
  const auto sigma_of = [&](std::string_view number) {
    const auto found = std::ranges::find(read.priors, number, &Prior::number);
    return found == read.priors.end() ? 0 : found->relative_sigma;
  };
  EXPECT_EQ(sigma_of("kt"), 0.02);
  EXPECT_EQ(sigma_of("resistance"), 0.15) << "of every bench";
  EXPECT_EQ(sigma_of("arm_mass"), 0.3);
  EXPECT_EQ(plain.goal_order, GoalOrder::kBeforeRead);
  EXPECT_EQ(read.goal_order, GoalOrder::kAfterRead);
  EXPECT_EQ(read.pendulum.gravity_m_s2, 0);
  EXPECT_EQ(read.logs[0].time_s.front(), 0.1);
  EXPECT_EQ(read.logs[0].time_s.back(), 2.2);
  EXPECT_NEAR(read.logs[0].position_rad[0], plain.logs[0].position_rad[8] - 0.05, 1e-9);
  EXPECT_NEAR(read.logs[0].goal_rad[0], plain.logs[0].goal_rad[8] - 0.05, 1e-9);
  for (const char* const key : {"kp=32", "payload_kg=1", "joint=Elbow", "torque_on=1", "load_raw=load_bit10"}) try {
      (void)declaring({key});
      ADD_FAILURE() << key;
    } catch (const BadInput& refused) {
      EXPECT_THAT(refused.what(), HasSubstr(messages::kOfCsv));
    }
}

TEST_F(DeclaredFolder, ADeclaredSupplyIsThatOfAllBamLogs) {
  const std::string with = bamText(zero, zero, "\"kp\": 8, \"motor\": \"mx28\"");
  write(folder / "a.json", replaced(with, "\"vin\": 12, ", ""));
  const auto declared = [&] {
    return readRawFolder({.folder = folder / "", .model = "", .declared = {"supply_V=11.1"}, .held_out = {}});
  };
  EXPECT_THAT(declared().notes, testing::Not(Contains(HasSubstr(messages::kReplacesVin))));
  write(folder / "b.json", with);
  const FolderCase read = declared();
  for (const Trajectory& log : read.given.logs) EXPECT_EQ(supplyOf(read.given, log), 11.1);
  EXPECT_THAT(read.notes, Contains(HasSubstr(messages::kReplacesVin + std::string{"1 logs"})));
}

TEST_F(DeclaredFolder, ASupplyThatIsNotDeclaredIsMeasuredOrAskedFor) {
  const auto with_volts = [](const std::string& load, const std::string& volts) {
    const std::string text = bamText([&](int) { return load; }, zero, "\"kp\": 8, \"motor\": \"mx28\"");
    std::string json = replaced(text, "\"vin\": 12, ", "");
    for (std::size_t at = 0; (at = json.find("12.1", at)) != std::string::npos; at += volts.size())
      json.replace(at, 4, volts);
    return json;
  };
  const auto reading = [&] {
    return readRawFolder({.folder = folder / "", .model = "", .declared = {}, .held_out = {}});
  };
  write(folder / "a.json", with_volts("12", "15.0"));
  write(folder / "b.json", with_volts("1030", "15.2"));
  const FolderCase measured = reading();
  for (const Trajectory& log : measured.given.logs) EXPECT_NEAR(supplyOf(measured.given, log), 15.1, 0.11);
  EXPECT_EQ(supplyOf(measured.given, measured.given.logs[0]), supplyOf(measured.given, measured.given.logs[1]));
  EXPECT_THAT(measured.notes, Contains(HasSubstr(messages::kSupplyMeasured)));
  write(folder / "b.json", with_volts("1030", "11.1"));
  const Case two = reading().given;
  EXPECT_EQ(supplyOf(two, two.logs[0]), 15.0);
  EXPECT_EQ(supplyOf(two, two.logs[1]), 11.1);
  for (const auto& [load, volts] : {std::pair{"300", "15.0"}, {"12", "0"}, {"12", "150"}}) {
    write(folder / "a.json", with_volts(load, volts));
    write(folder / "b.json", with_volts(load, volts));
    try {
      (void)reading();
      ADD_FAILURE() << "under load, or not read, or in tenths: " << volts;
    } catch (const BadInput& refused) {
      EXPECT_THAT(refused.what(), testing::AllOf(HasSubstr(messages::kNotDeclared), HasSubstr("supply_V")));
    }
  }
}

TEST_F(DeclaredFolder, ASupplyThatTheVoltagesContradictIsNoted) {
  const std::string idle = bamText([](int) { return "12"; }, zero, "\"kp\": 8, \"motor\": \"mx28\"");
  const auto notes_of = [&](const std::string& log) {
    write(folder / "a.json", log);
    return readRawFolder({.folder = folder / "", .model = "", .declared = {}, .held_out = {}}).notes;
  };
  const auto is_noted = Contains(testing::AllOf(HasSubstr("supply_V"), HasSubstr(messages::kContradicted)));
  EXPECT_THAT(notes_of(idle), testing::Not(is_noted));
  EXPECT_THAT(notes_of(replaced(idle, "\"vin\": 12", "\"vin\": 15")), is_noted);
}

TEST_F(DeclaredFolder, AnotherMotorIsDeclaredInFull) {
  write(folder / "a.json", bamText(zero, zero, kUnknownMotor));
  const auto declaring = [&](const std::vector<std::string>& words) -> std::string {
    try {
      (void)readRawFolder({.folder = folder / "", .model = "", .declared = words, .held_out = {}});
    } catch (const BadInput& refused) {
      return refused.what();
    }
    return "";
  };
  const std::string sheet = "stall_Nm_at_12V=8.4", current = "stall_A_at_12V=5.2", gain = "duty_per_kp_per_rad=0.158";
  EXPECT_EQ(declaring({sheet, current, gain}), "");
  EXPECT_THAT(declaring({"armature_kgm2=0.03"}),
              testing::AllOf(HasSubstr(messages::kNotDeclared), HasSubstr("stall_Nm"), HasSubstr("duty_per_kp")));
  EXPECT_THAT(declaring({sheet, gain}), HasSubstr("stall_A"));
}

TEST_F(DeclaredFolder, TheArmatureOfAnotherServoIsNoted) {
  const TemporaryFolder csv;
  write(folder / "a.json", bamText(zero, zero, kUnknownMotor));
  write(csv / "a.csv", csvOf(sineRows()));
  const auto notes_for = [&](const std::string& from, std::vector<std::string> words) {
    for (const char* const one : {"stall_Nm_at_12V=8.4", "stall_A_at_12V=5.2", "duty_per_kp_per_rad=0.158"})
      words.emplace_back(one);
    return readRawFolder({.folder = from, .model = "", .declared = words, .held_out = {}}).notes;
  };
  const auto is_noted = Contains(HasSubstr(messages::kArmatureAssumed));
  EXPECT_THAT(notes_for(folder / "", {}), is_noted);
  EXPECT_THAT(notes_for(folder / "", {"armature_kgm2=0.02"}), testing::Not(is_noted));
  EXPECT_THAT(notes_for(folder / "", {"armature_kgm2=0.02", "firmware_dt_s=0.002"}),
              testing::Not(Contains(HasSubstr(messages::kLeftAside))));
  EXPECT_THAT(notes_for(csv / "", {"kp=32", "payload_kg=0.3", "length_m=0.17", "supply_V=12"}), is_noted);
}

}  // namespace
}  // namespace darwinop::gap
