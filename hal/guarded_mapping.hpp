// Shared file mapping that survives truncation of the file by another process.
#pragma once

#include <atomic>
#include <cstddef>

namespace darwinop {

/// Accessing a page beyond the end of the file raises SIGBUS, which would end the process with torque on. For addresses
/// in these mappings the handler replaces the whole mapping by empty private memory and sets lost(); the interrupted
/// instruction then continues. SIGBUS at any other address has its previous effect.
///
/// The handler takes no lock and allocates nothing. If two threads fault at once, both replace the mapping: what the
/// first one wrote in between is lost, and every word reads 0.
class GuardedMapping {
 public:
  /// Empty: nothing is mapped.
  GuardedMapping() = default;
  /// Maps the first `size` bytes of the file, shared. Throws std::system_error, also if kMost are already mapped.
  GuardedMapping(int fd, std::size_t size, int protection);
  ~GuardedMapping();
  GuardedMapping(GuardedMapping&& other) noexcept;
  GuardedMapping& operator=(GuardedMapping&& other) noexcept;

  static constexpr std::size_t kMost = 64;  // per process

  [[nodiscard]] void* data() const { return data_; }
  /// True if the file was truncated; writes are then visible to this process only. Any thread, during the lifetime of
  /// the mapping.
  [[nodiscard]] const std::atomic<bool>& lost() const;

 private:
  void* data_ = nullptr;
  std::size_t slot_ = 0;
};

}  // namespace darwinop
