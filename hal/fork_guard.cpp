// Replaces guarded descriptors in a forked child.
#include "hal/fork_guard.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdint>

namespace darwinop {
namespace {

constexpr int kBits = 32;
/// One bit for each descriptor. No mutex: a thread that holds one does not exist in the child.
constinit std::array<std::atomic<std::uint32_t>, 1024 / kBits> guarded{};

std::atomic<std::uint32_t>* wordOf(int fd) noexcept {
  const auto word = static_cast<std::size_t>(fd) / kBits;
  return fd >= 0 && word < guarded.size() ? &guarded[word] : nullptr;
}

std::uint32_t bitOf(int fd) noexcept {
  return std::uint32_t{1} << (fd % kBits);
}

void replace(int fd) noexcept {
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0 || ::dup3(nothing, fd, O_CLOEXEC) < 0) ::close(fd);
  if (nothing >= 0) ::close(nothing);
}

/// Runs in the child before fork() returns: async-signal-safe calls only.
void replaceAll() noexcept {
  const int error = errno;
  for (std::size_t word = 0; word < guarded.size(); ++word)
    for (std::uint32_t bits = guarded[word].exchange(0); bits != 0; bits &= bits - 1)
      replace(static_cast<int>(word) * kBits + std::countr_zero(bits));
  errno = error;
}

}  // namespace

void guardFromForks(int fd) noexcept {
  [[maybe_unused]] static const int registered = ::pthread_atfork(nullptr, nullptr, replaceAll);
  if (auto* const word = wordOf(fd); word != nullptr) word->fetch_or(bitOf(fd));
}

void unguardFromForks(int fd) noexcept {
  if (auto* const word = wordOf(fd); word != nullptr) word->fetch_and(~bitOf(fd));
}

}  // namespace darwinop
