// Memory mapped from a file that another process can shorten.
#pragma once

#include <atomic>
#include <cstddef>

namespace darwinop {

/// Touching a page that the file no longer has raises SIGBUS, which ends a process at once: a loop would leave its
/// joints under torque. For the ranges of these objects the handler puts empty private memory in the place of the whole
/// mapping and sets lost(). The instruction that was interrupted then continues. SIGBUS of any other address has the
/// effect that it had before.
///
/// The handler takes no lock and allocates nothing. Two threads that are interrupted at once both replace the mapping;
/// what the first wrote meanwhile is gone, and every word reads 0.
class GuardedMapping {
 public:
  /// Nothing is mapped.
  GuardedMapping() = default;
  /// The first `size` bytes of the file, shared. Throws std::system_error, also when kMost are mapped already.
  GuardedMapping(int fd, std::size_t size, int protection);
  ~GuardedMapping();
  GuardedMapping(GuardedMapping&& other) noexcept;
  GuardedMapping& operator=(GuardedMapping&& other) noexcept;

  static constexpr std::size_t kMost = 64;  // of one process

  [[nodiscard]] void* data() const { return data_; }
  /// True: the file was shortened, and this process alone sees what is written here. Any thread, for as long as the
  /// mapping lives.
  [[nodiscard]] const std::atomic<bool>& lost() const;

 private:
  void* data_ = nullptr;
  std::size_t slot_ = 0;
};

}  // namespace darwinop
