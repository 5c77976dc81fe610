// The memory between the loop and those who use it: commands one way, sensors and figures the other way.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
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

/// Set before the loop begins, then constant.
struct LoopInfo {
  std::int64_t period_ns = 0;
  std::int32_t pid = 0;  // of the process that hosts the loop
  char robot[64] = {};   // a person's name for the robot
  char port[160] = {};   // what the bus is: "/dev/ttyUSB0 (CM-730 firmware 19, 20 servos)"
  // The robot's [Safety] and [Limits]; a session can make them stricter.
  SessionSettings safety{};
  std::uint32_t safety_named = 0;  // Config::named
};

/// Hash of names, offsets, sizes and types of all that the two blocks hold: exchange_layout.cpp.
std::uint64_t exchangeLayout();

/// Output of the loop. Written by its process alone, which stores whole values and never counts on from what it finds
/// here; everybody else maps it read-only. Plain words and bytes, no pointers.
struct ExchangeBlock {
  static constexpr std::uint32_t kMagic = 0x50774f44;  // "DOwP"

  /// Values of `closing`. kClosing: the loop brings the robot to rest, then ends. kNoControllers: no controller may
  /// drive, and the loop goes on by itself, as in a rescue.
  static constexpr std::uint32_t kOpen = 0, kClosing = 1, kNoControllers = 2;

  std::atomic<std::uint32_t> magic{kMagic};
  std::uint32_t size = sizeof(ExchangeBlock);
  std::uint64_t layout = exchangeLayout();
  std::uint32_t instance = 0;  // the same number as in the CommandBlock that belongs to it
  LoopInfo info{};

  Latest<Sensors> sensors;
  WakeWord finished;                       // low 32 bits of Sensors::cycle; moves when a cycle is finished
  std::atomic<std::uint32_t> closing{0};   // kOpen, kClosing or kNoControllers
  std::atomic<std::uint32_t> session{0};   // highest number of a driving session, or of a release, so far
  std::atomic<std::uint32_t> released{0};  // number that the last release got; 0: there was none
  std::atomic<std::uint32_t> refused{0};   // session that publishes and is not obeyed because of a release; 0: none
  LoopStats stats;
};

/// What the loop is asked for. The runtime's group may write every byte of it, so the loop trusts none.
struct CommandBlock {
  std::atomic<std::uint32_t> instance{0};  // the loop writes it in every cycle
  Latest<Commands> commands;
  std::atomic<std::uint32_t> session_taken{0};  // number that the last driver has chosen
  RequestWord fault_reset, release;
  WaitNote wait;
};

/// Holds both blocks, in private memory or mapped from files.
class Exchange {
 public:
  /// Private memory: loop and controller are one process, without observers.
  static Exchange inMemory();

  /// For a loop in the controller's own process: the file that DARWINOP_EXCHANGE names, so that others can read
  /// on, or private memory when it is unset.
  static Exchange embedded();

  /// New files `path` and `path`.commands that replace old ones. Processes that still map the old ones keep them.
  static Exchange create(const std::string& path, gid_t group = static_cast<gid_t>(-1));
  /// The same, and the commands lie in private memory: other processes can observe, but not drive.
  static Exchange createObservable(const std::string& path, gid_t group = static_cast<gid_t>(-1));
  /// Removes the files.
  static void remove(const std::string& path) noexcept;

  enum class Access {
    kUse,   // commands can be written
    kRead,  // nothing can be written
  };
  /// Existing files. Throws std::runtime_error, with a sentence for the user, when there are none, when they must not
  /// be used, or when they are not of this build.
  static Exchange attach(const std::string& path, Access access = Access::kUse);

  [[nodiscard]] const ExchangeBlock& block() const { return *block_; }
  /// Where this process hosts the loop. Throws std::logic_error elsewhere.
  [[nodiscard]] ExchangeBlock& ownBlock() const;
  /// Throws std::logic_error when this process may only read.
  [[nodiscard]] CommandBlock& commands() const;

  /// Somebody has shortened or overwritten a file: what is written here reaches nobody, what is read is empty.
  [[nodiscard]] bool lost() const noexcept;
  /// The same for the process that hosts the loop, and sooner: also when what is missing was not touched yet. Asks the
  /// kernel; not for the loop's thread.
  [[nodiscard]] bool shortened() const;

 private:
  Exchange() = default;
  static Exchange made(const std::string& path, gid_t group, bool commands_in_file);

  std::unique_ptr<ExchangeBlock> private_block_;
  std::unique_ptr<CommandBlock> private_commands_;
  GuardedMapping block_file_, commands_file_;
  SharedFile own_block_{-1}, own_commands_{-1};  // open in the process that hosts the loop
  ExchangeBlock* block_ = nullptr;
  CommandBlock* commands_ = nullptr;
  bool own_ = true;
};

/// Sentence for a controller whose exchange is lost.
inline constexpr const char* kExchangeLost =
    "the runtime's shared memory was shortened or overwritten by another program, so no commands get through; start "
    "runtime and controller again";

/// Copies what fits, always ended by 0.
void setText(char* to, std::size_t size, const std::string& text);

}  // namespace darwinop::runtime
