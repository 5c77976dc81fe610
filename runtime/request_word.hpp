// A request to the loop, in memory that others may write.
#pragma once

#include <atomic>
#include <cstdint>

namespace darwinop::runtime {

/// A number and its complement. A program that writes where it should not changes one of them, or both to values that
/// do not belong together: that is not a request.
class RequestWord {
 public:
  /// Any process.
  void ask() noexcept {
    const std::uint32_t next = count_.load() + 1;
    complement_.store(~next);  // first: until both are there the pair is not valid
    count_.store(next);
  }
  /// The loop. `seen`: its own memory of the number; 0 at first. True once for each request; several between two calls
  /// are one.
  [[nodiscard]] bool isNew(std::uint32_t& seen) const noexcept {
    const std::uint32_t count = count_.load(), before = seen;
    seen = count;
    return complement_.load() == ~count && count != before;
  }

 private:
  std::atomic<std::uint32_t> count_{0}, complement_{0};
};

}  // namespace darwinop::runtime
