// Fault script: an error message, or a script that runs.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "hil-mocks/fault_script.hpp"
#include "hil-mocks/virtual_robot.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace darwinop::hil;
  try {
    const std::vector<InjectedFault> faults = parseFaultScript({reinterpret_cast<const char*>(data), size}, "fuzz");
    BoardOptions options;
    options.body_step = std::chrono::milliseconds{100};
    VirtualRobot robot{options};
    robot.faults().add(faults);
    robot.advance(std::chrono::seconds{2});
  } catch (const std::runtime_error&) {
  }
  return 0;
}
