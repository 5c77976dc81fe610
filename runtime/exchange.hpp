// Shared memory between the loop and its clients: commands in, sensors and statistics out.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "hal/guarded_mapping.hpp"
#include "runtime/futex.hpp"
#include "runtime/latest.hpp"
#include "runtime/loop_stats.hpp"
#include "runtime/request_word.hpp"
#include "runtime/shared_file.hpp"

namespace darwinop::runtime {

/// Written before the loop starts, then constant.
struct LoopInfo {
  std::int64_t period_ns = 0;
  std::int32_t pid = 0;  // of the process that hosts the loop
  char robot[64] = {};   // the robot's name, for display
  char port[160] = {};   // description of the bus: "/dev/ttyUSB0 (CM-730 firmware 19, 20 servos)"
  // The robot's [Safety] and [Limits]; a session can make them stricter.
  SessionSettings safety{};
  std::uint32_t safety_named = 0;  // Config::named
};

/// Hash of names, offsets, sizes and types of all fields of the two blocks: exchange_layout.cpp.
std::uint64_t exchangeLayout();

/// Output of the loop. Only the loop's process writes it, and it never reads its own output back; all other processes
/// map it read-only. Contains no pointers.
struct ExchangeBlock {
  static constexpr std::uint32_t kMagic = 0x50774f44;  // "DOwP"

  /// Values of `closing`. kEnding: the controller is requested to end, and is obeyed until it has, so that it can
  /// finish a step. kClosing: the loop brings the robot to rest, then ends. kNoControllers: no controller may drive;
  /// the loop continues without one, as in a rescue.
  static constexpr std::uint32_t kOpen = 0, kClosing = 1, kNoControllers = 2, kEnding = 3;

  std::atomic<std::uint32_t> magic{kMagic};
  std::uint32_t size = sizeof(ExchangeBlock);
  std::uint64_t layout = exchangeLayout();
  std::uint32_t instance = 0;  // the same number as in the matching CommandBlock
  LoopInfo info{};

  Latest<Sensors> sensors;
  WakeWord finished;                       // low 32 bits of Sensors::cycle; changes when a cycle is finished
  std::atomic<std::uint32_t> closing{0};   // kOpen, kClosing, kNoControllers or kEnding
  std::atomic<std::uint32_t> session{0};   // highest number of a session or a release so far
  std::atomic<std::uint32_t> released{0};  // number of the last release; 0: none
  std::atomic<std::uint32_t> refused{0};   // session whose commands are ignored because of a release; 0: none
  LoopStats stats;
};

/// Input of the loop. Every process of the runtime's group can write every byte of it, so the loop validates all of it.
struct CommandBlock {
  std::atomic<std::uint32_t> instance{0};  // written by the loop in every cycle
  Latest<Commands> commands;
  std::atomic<std::uint32_t> session_taken{0};  // chosen by the last driver
  RequestWord fault_reset, release;
  WaitNote wait;
};

/// Both blocks, in private memory or mapped from files.
class Exchange {
 public:
  /// Private memory: loop and controller share one process, without observers.
  static Exchange inMemory();

  /// For a loop in the controller's process: the file named by DARWINOP_EXCHANGE, so that other processes can observe;
  /// private memory if it is unset.
  static Exchange embedded();

  /// Creates the files `path` and `path`.commands. Existing ones are replaced; processes that map those keep them.
  /// `fill` writes what must be there before other processes can attach.
  static Exchange create(const std::string& path, gid_t group = static_cast<gid_t>(-1),
                         const std::function<void(ExchangeBlock&)>& fill = {});
  /// The same with the commands in private memory: other processes can observe but not drive.
  static Exchange createObservable(const std::string& path, gid_t group = static_cast<gid_t>(-1));
  /// Removes the files.
  static void remove(const std::string& path) noexcept;

  enum class Access {
    kUse,   // commands can be written
    kRead,  // nothing can be written
  };
  /// Maps existing files. Throws std::runtime_error with a message for the user if there are none, if their owner or
  /// permissions are not trusted, or if another build wrote them.
  static Exchange attach(const std::string& path, Access access = Access::kUse);

  [[nodiscard]] const ExchangeBlock& block() const { return *block_; }
  /// For the process that hosts the loop; throws std::logic_error in others.
  [[nodiscard]] ExchangeBlock& ownBlock() const;
  /// Throws std::logic_error if this process has read access only.
  [[nodiscard]] CommandBlock& commands() const;

  /// True if another process truncated or overwrote a file: writes have no effect outside this process, and reads
  /// return zeros.
  [[nodiscard]] bool lost() const noexcept;
  /// The same for the process that hosts the loop, detected before the missing part is accessed. Makes system calls;
  /// not for the loop's thread.
  [[nodiscard]] bool shortened() const;

 private:
  Exchange() = default;
  static Exchange made(const std::string& path, gid_t group, bool commands_in_file,
                       const std::function<void(ExchangeBlock&)>& fill);

  std::unique_ptr<ExchangeBlock> private_block_;
  std::unique_ptr<CommandBlock> private_commands_;
  GuardedMapping block_file_, commands_file_;
  Descriptor own_block_{-1}, own_commands_{-1};  // open in the process that hosts the loop
  ExchangeBlock* block_ = nullptr;
  CommandBlock* commands_ = nullptr;
  bool own_ = true;
};

/// Message for a controller whose exchange is lost.
inline constexpr const char* kExchangeLost =
    "the runtime's shared memory was shortened or overwritten by another program, so no commands get through; start "
    "runtime and controller again";

/// Copies as much as fits; always zero-terminated.
void setText(char* to, std::size_t size, const std::string& text);

}  // namespace darwinop::runtime
