// Which product files can write to a serial line: the bus, the start-up check, and what calls openSerialBus(), which
// judges the robot. Another entry point would skip the judgement.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <set>
#include <string>

#include "support/text_of.hpp"

namespace darwinop::connect {
namespace {

namespace fs = std::filesystem;

using Files = std::set<std::string>;

/// Product files, relative to the source tree, that contain one of these texts.
Files filesWith(std::initializer_list<const char*> texts) {
  const fs::path root{DARWINOP_SOURCE_TREE};
  Files found;
  for (const char* room : {"apps", "connect", "controllers", "core", "experiments", "gap", "hal", "managers", "monitor",
                           "remote", "runtime", "safety", "supervisor", "twin", "webots", "window"})
    for (const auto& entry : fs::recursive_directory_iterator{root / room}) {
      const fs::path path = entry.path();
      if (path.extension() != ".cpp" && path.extension() != ".hpp") continue;
      const std::string source = textOf(path.string());
      if (std::ranges::any_of(texts, [&](const char* text) { return source.find(text) != source.npos; }))
        found.insert(path.lexically_relative(root).string());
    }
  return found;
}

TEST(EntryPoints, NothingWritesToASerialLineButWhatHasJudgedTheRobot) {
  EXPECT_EQ(filesWith({"#include \"hal/cm730/serial_port.hpp\"", "#include \"hal/cm730/serial_open.hpp\""}),
            (Files{"apps/doctor.cpp", "connect/serial_bus.cpp", "hal/cm730/diagnosis/port_check.cpp",
                   "hal/cm730/diagnosis/port_check.hpp", "hal/cm730/serial_errors.cpp", "hal/cm730/serial_open.cpp",
                   "hal/cm730/serial_port.cpp"}));
  EXPECT_EQ(filesWith({"#include \"hal/cm730/bus.hpp\""}),
            (Files{"connect/owned_bus.hpp", "hal/cm730/bus.cpp", "hal/cm730/diagnosis/diagnosis.cpp"}));
  EXPECT_EQ(
      filesWith({"writeRegisters(", "encodeWrite(", "SyncWriteEncoder"}),
      (Files{"core/packet.cpp", "core/packet.hpp", "hal/cm730/bus.cpp", "hal/cm730/diagnosis/instruction_trial.cpp",
             "hal/cm730/diagnosis/probe.cpp", "hal/cm730/diagnosis/transactions.cpp",
             "hal/cm730/diagnosis/transactions.hpp", "hal/cm730/goal_writer.cpp"}));
  EXPECT_EQ(filesWith({"openSerialBus("}), (Files{"apps/runtime.cpp", "connect/connect.cpp", "connect/serial_bus.cpp",
                                                  "connect/serial_bus.hpp", "supervisor/rescue.cpp"}));
}

}  // namespace
}  // namespace darwinop::connect
