// Which product files can write to a serial line: the bus, the start-up check, and what calls openSerialBus(), which
// judges the robot. Another entry point would skip the judgement.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "support/text_of.hpp"

namespace darwinop::connect {
namespace {

namespace fs = std::filesystem;

/// Product files, relative to the source tree, in which the expression is found.
std::set<std::string> filesWith(const char* expression) {
  const std::regex pattern{expression};
  const fs::path root{DARWINOP_SOURCE_TREE};
  std::set<std::string> found;
  for (const char* room : {"apps", "connect", "controllers", "core", "experiments", "gap", "hal", "managers", "monitor",
                           "remote", "runtime", "safety", "supervisor", "twin", "webots", "window"})
    for (const auto& entry : fs::recursive_directory_iterator{root / room})
      if ((entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") &&
          std::regex_search(textOf(entry.path().string()), pattern))
        found.insert(entry.path().lexically_relative(root).string());
  return found;
}

TEST(EntryPoints, NothingWritesToASerialLineButWhatHasJudgedTheRobot) {
  using Files = std::set<std::string>;
  EXPECT_EQ(filesWith(R"(#include "hal/cm730/serial_(port|open)\.hpp")"),
            (Files{"apps/doctor.cpp", "connect/connect.cpp", "hal/cm730/diagnosis/port_check.cpp",
                   "hal/cm730/diagnosis/port_check.hpp", "hal/cm730/serial_errors.cpp",
                   "hal/cm730/serial_open.cpp", "hal/cm730/serial_port.cpp"}));
  EXPECT_EQ(filesWith(R"(#include "hal/cm730/bus\.hpp")"),
            (Files{"connect/owned_bus.hpp", "hal/cm730/bus.cpp",
                   "hal/cm730/diagnosis/diagnosis.cpp"}));
  EXPECT_EQ(
      filesWith(R"(\b(writeRegisters|encodeWrite|SyncWriteEncoder)\b)"),
      (Files{"core/packet.cpp", "core/packet.hpp", "hal/cm730/bus.cpp", "hal/cm730/diagnosis/instruction_trial.cpp",
             "hal/cm730/diagnosis/probe.cpp", "hal/cm730/diagnosis/transactions.cpp",
             "hal/cm730/diagnosis/transactions.hpp", "hal/cm730/goal_writer.cpp"}));
  EXPECT_EQ(filesWith(R"(\bopenSerialBus\()"),
            (Files{"apps/runtime.cpp", "connect/connect.cpp", "connect/connect.hpp", "supervisor/rescue.cpp"}));
}

}  // namespace
}  // namespace darwinop::connect
