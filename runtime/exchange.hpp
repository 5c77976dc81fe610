// The memory between the loop and those who use it: commands one way, sensors and figures the other way.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "runtime/futex.hpp"
#include "runtime/latest.hpp"
#include "runtime/loop_stats.hpp"

namespace darwinop::runtime {

/// Set before the loop begins, then constant.
struct LoopInfo {
  std::int64_t period_ns = 0;
  std::int32_t pid = 0;  // of the process that hosts the loop
  char robot[64] = {};   // a person's name for the robot
  char port[160] = {};   // what the bus is: "/dev/ttyUSB0 (CM-730 firmware 19, 20 servos)"
};

/// Plain words and bytes, no pointers: the same in private memory and in a file that processes share.
struct ExchangeBlock {
  static constexpr std::uint32_t kMagic = 0x50774f44;  // "DOwP"
  static constexpr std::uint32_t kLayout = 3;          // count up when a member here or in the images changes

  std::uint32_t magic = kMagic;
  std::uint32_t layout = kLayout;
  std::uint32_t size = sizeof(ExchangeBlock);
  LoopInfo info{};

  Latest<Commands> commands;                   // written by the driver
  Latest<Sensors> sensors;                     // written by the loop
  LoopStats stats;                             // written by the loop
  WakeWord finished;                           // low 32 bits of Sensors::cycle; moves when a cycle is finished
  std::atomic<std::uint32_t> closing{0};       // 1: the loop brings the robot to rest, then ends
  std::atomic<std::uint32_t> session{0};       // last driving session that was granted
  std::atomic<std::uint32_t> fault_resets{0};  // operator's requests, added to those of the controller
  std::atomic<std::uint32_t> released{0};      // session in which an operator took all torque away; 0: never
};

/// Holds an ExchangeBlock, in private memory or mapped from a file.
class Exchange {
 public:
  /// Private memory: loop and controller are one process and nobody looks on.
  static Exchange inMemory();

  /// For a loop in the controller's own process: the file that DARWINOP_EXCHANGE names, so that others can look
  /// on, or private memory when it is unset.
  static Exchange embedded();

  /// A new file that replaces an old one of that path. Processes that still map the old one keep it, unharmed.
  static Exchange create(const std::string& path, gid_t group = static_cast<gid_t>(-1));

  /// kLook: the memory cannot be written; a mistake ends who makes it and not the loop.
  enum class Access { kUse, kLook };
  /// An existing file. Throws std::runtime_error, with a sentence for the user, when there is none or when it is
  /// not of this build.
  static Exchange attach(const std::string& path, Access access = Access::kUse);

  [[nodiscard]] ExchangeBlock& block() const { return *block_; }

 private:
  using Home = std::unique_ptr<ExchangeBlock, void (*)(ExchangeBlock*)>;
  explicit Exchange(Home block) : block_{std::move(block)} {}
  Home block_;
};

/// Copies what fits, always ended by 0.
void setText(char* to, std::size_t size, const std::string& text);

}  // namespace darwinop::runtime
