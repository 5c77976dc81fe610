// Request counter in memory that other processes can write.
#pragma once

#include <atomic>
#include <cstdint>

namespace darwinop::runtime {

/// A number and its complement: a stray write makes the pair inconsistent and is not taken for a request.
class RequestWord {
 public:
  /// Any process.
  void ask() noexcept {
    const std::uint32_t next = count_.load() + 1;
    complement_.store(~next);  // first: the pair is invalid until both are written
    count_.store(next);
  }
  /// For the loop. `seen`: its private copy of the number, initially 0. True once per request; several requests between
  /// two calls count as one.
  [[nodiscard]] bool isNew(std::uint32_t& seen) const noexcept {
    const std::uint32_t count = count_.load(), before = seen;
    seen = count;
    return complement_.load() == ~count && count != before;
  }

 private:
  std::atomic<std::uint32_t> count_{0}, complement_{0};
};

}  // namespace darwinop::runtime
