// Buffers mapped by a program, and their queues.
#pragma once

#include <sys/time.h>

#include <cstddef>
#include <cstdint>

namespace darwinop::hil::shim {

inline constexpr std::uint32_t kMostBuffers = 32;  // VIDEO_MAX_FRAME

struct Buffer {
  enum State : std::uint8_t { kWithProgram, kQueued, kFilled };
  State state = kWithProgram;
  bool mapped = false, damaged = false;
  std::uint32_t bytes = 0, sequence = 0;
  timeval time = {};
};

/// First in, first out.
class Line {
 public:
  void push(std::uint32_t index) { index_[count_++] = index; }
  std::uint32_t pop();
  void clear() { count_ = 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }

 private:
  std::uint32_t index_[kMostBuffers] = {};
  std::uint32_t count_ = 0;
};

/// Mapped memory stays readable after release() until the program unmaps it.
class Buffers {
 public:
  int allocate(std::uint32_t count, std::uint32_t bytes_each);  // 0 or an errno; releases previous buffers
  void release();
  void takeBack();  // returns all buffers to the program
  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] std::uint32_t bytes() const { return bytes_; }
  Buffer& operator[](std::uint32_t index) { return buffer_[index]; }
  [[nodiscard]] std::uint8_t* data(std::uint32_t index) const { return memory_ + offset(index); }
  /// Offset for mmap().
  [[nodiscard]] std::uint32_t offset(std::uint32_t index) const { return index * stride_; }
  [[nodiscard]] int descriptor() const { return fd_; }

  Line queued, filled;

 private:
  int fd_ = -1;
  std::uint8_t* memory_ = nullptr;
  std::uint32_t count_ = 0, bytes_ = 0, stride_ = 0;
  Buffer buffer_[kMostBuffers] = {};
};

}  // namespace darwinop::hil::shim
