#include "hal/guarded_mapping.hpp"

#include <signal.h>
#include <sys/mman.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <mutex>
#include <system_error>
#include <utility>

namespace darwinop {
namespace {

/// Read by the signal handler. `begin` is written last and cleared first.
struct GuardedRange {
  std::atomic<void*> begin{nullptr};
  std::atomic<std::uintptr_t> size{0};
  std::atomic<bool> lost{false};
  bool taken = false;  // protected by the mutex
};
static_assert(std::atomic<void*>::is_always_lock_free && std::atomic<std::uintptr_t>::is_always_lock_free &&
              std::atomic<bool>::is_always_lock_free);

std::array<GuardedRange, GuardedMapping::kMost> guarded_ranges;
std::mutex guarded_ranges_mutex;
struct sigaction action_before {};
const std::atomic<bool> kNeverLost{false};

bool replace(std::uintptr_t address) {
  for (GuardedRange& range : guarded_ranges) {
    void* const memory = range.begin.load();
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    if (begin == 0 || address < begin || address - begin >= range.size.load()) continue;
    range.lost.store(true);
    return mmap(memory, range.size.load(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) !=
           MAP_FAILED;
  }
  return false;
}

void onMissingPage(int signal, siginfo_t* info, void*) {
  const int error = errno;
  const bool fault = info->si_code > 0;  // not sent by kill()
  if (!fault || !replace(reinterpret_cast<std::uintptr_t>(info->si_addr))) {
    // Returning repeats the access, which then meets the previous action.
    sigaction(signal, &action_before, nullptr);
    (void)raise(signal);
  }
  errno = error;
}

/// Also restores our handler if another one was installed since the last mapping.
void installHandler() {
  struct sigaction now {};
  sigaction(SIGBUS, nullptr, &now);
  if ((now.sa_flags & SA_SIGINFO) != 0 && now.sa_sigaction == onMissingPage) return;
  action_before = now;
  struct sigaction action {};
  action.sa_sigaction = onMissingPage;
  action.sa_flags = static_cast<int>(SA_SIGINFO | SA_ONSTACK | SA_RESTART);
  sigaction(SIGBUS, &action, nullptr);
}

std::size_t takeRange() {
  for (std::size_t i = 0; i < guarded_ranges.size(); ++i)
    if (!std::exchange(guarded_ranges[i].taken, true)) return i;
  throw std::system_error(ENFILE, std::generic_category(), "too many guarded mappings");
}

}  // namespace

GuardedMapping::GuardedMapping(int fd, std::size_t size, int protection) {
  const std::lock_guard lock{guarded_ranges_mutex};
  installHandler();
  slot_ = takeRange();
  GuardedRange& range = guarded_ranges[slot_];
  void* const memory = mmap(nullptr, size, protection, MAP_SHARED, fd, 0);
  if (memory == MAP_FAILED) {
    range.taken = false;
    throw std::system_error(errno, std::generic_category(), "mmap");
  }
  data_ = memory;
  range.lost.store(false);
  range.size.store(size);
  range.begin.store(memory);
}

GuardedMapping::~GuardedMapping() {
  if (data_ == nullptr) return;
  const std::lock_guard lock{guarded_ranges_mutex};
  GuardedRange& range = guarded_ranges[slot_];
  range.begin.store(nullptr);
  munmap(data_, range.size.load());
  range.taken = false;
}

GuardedMapping::GuardedMapping(GuardedMapping&& other) noexcept
    : data_{std::exchange(other.data_, nullptr)}, slot_{other.slot_} {}

GuardedMapping& GuardedMapping::operator=(GuardedMapping&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(slot_, other.slot_);
  return *this;
}

const std::atomic<bool>& GuardedMapping::lost() const {
  return data_ == nullptr ? kNeverLost : guarded_ranges[slot_].lost;
}

}  // namespace darwinop
