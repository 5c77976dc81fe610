// Which product files can write to a serial line: the bus, the start-up check, and what calls openSerialBus(), which
// judges the robot. Another entry point would skip the judgement.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <set>
#include <sstream>
#include <string>

#include "support/text_of.hpp"

namespace darwinop::connect {
namespace {

namespace fs = std::filesystem;

using Files = std::set<std::string>;

const fs::path kRoot{DARWINOP_SOURCE_TREE};

/// Top-level folders of the product: those of the table of rooms, whose rows begin with floor and path, and the
/// examples. Not the virtual robot, which is the other end of the line.
std::set<std::string> productFolders() {
  std::ifstream table{kRoot / "tools/cmake/rooms.table"};
  std::set<std::string> folders{"controllers"};
  for (std::string line, path; std::getline(table, line);) {
    int floor = 0;
    char bar = 0;
    if (std::istringstream{line} >> floor >> bar >> path) folders.insert(fs::path{path}.begin()->string());
  }
  folders.erase("hil-mocks");
  return folders;
}

/// Product files, relative to the source tree, that contain one of these texts.
Files filesWith(std::initializer_list<const char*> texts) {
  Files found;
  for (const std::string& room : productFolders())
    for (const auto& entry : fs::recursive_directory_iterator{kRoot / room}) {
      const fs::path path = entry.path();
      if (path.extension() != ".cpp" && path.extension() != ".hpp") continue;
      const std::string source = textOf(path.string());
      if (std::ranges::any_of(texts, [&](const char* text) { return source.find(text) != source.npos; }))
        found.insert(path.lexically_relative(kRoot).string());
    }
  return found;
}

TEST(EntryPoints, EveryRoomIsSearched) {
  const std::set<std::string> folders = productFolders();
  for (const char* room : {"apps", "connect", "controllers", "hal", "supervisor", "window"})
    EXPECT_TRUE(folders.contains(room)) << room;
}

TEST(EntryPoints, NothingWritesToASerialLineButWhatHasJudgedTheRobot) {
  EXPECT_EQ(filesWith({"#include \"hal/cm730/serial_port.hpp\"", "#include \"hal/cm730/serial_open.hpp\""}),
            (Files{"apps/doctor.cpp", "connect/serial_bus.cpp", "hal/cm730/diagnosis/fault_naming.cpp",
                   "hal/cm730/diagnosis/port_check.cpp", "hal/cm730/diagnosis/port_check.hpp",
                   "hal/cm730/serial_errors.cpp", "hal/cm730/serial_open.cpp", "hal/cm730/serial_port.cpp"}));
  EXPECT_EQ(filesWith({"#include \"hal/cm730/bus.hpp\""}),
            (Files{"connect/owned_bus.hpp", "hal/cm730/bus.cpp", "hal/cm730/diagnosis/cycle_time.cpp"}));
  EXPECT_EQ(
      filesWith({"writeRegisters(", "encodeWrite(", "SyncWriteEncoder"}),
      (Files{"core/packet.cpp", "core/packet.hpp", "hal/cm730/bus.cpp", "hal/cm730/diagnosis/instruction_trial.cpp",
             "hal/cm730/diagnosis/observation.cpp", "hal/cm730/diagnosis/probe.cpp",
             "hal/cm730/diagnosis/probe_requests.hpp", "hal/cm730/diagnosis/transactions.cpp",
             "hal/cm730/diagnosis/transactions.hpp", "hal/cm730/goal_writer.cpp"}));
  EXPECT_EQ(filesWith({"openSerialBus("}), (Files{"apps/runtime.cpp", "connect/connect.cpp", "connect/serial_bus.cpp",
                                                  "connect/serial_bus.hpp", "supervisor/rescue.cpp"}));
}

}  // namespace
}  // namespace darwinop::connect
