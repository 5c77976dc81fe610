// Newest-value mailbox (sequence lock over several slots): one writer, many readers, in private or shared memory. Never
// blocks.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace darwinop::runtime {

/// Contains no pointers, so processes can share it. If the writer dies during publish(), the previous value stays valid
/// and the next writer continues.
///
/// The writer fills slots in turn; `newest_` counts the publications and selects the finished slot. A slot stores the
/// count it was filled for, 0 while it is being filled; by this a reader detects that the slot was overwritten. Words
/// are stored with release and loaded with acquire order (plain moves on x86): a reader that sees one word of a newer
/// value also sees the changed count. Words have the size of a pointer, which one plain move loads or stores.
///
/// With four slots a read fails only if three more values are published while it copies.
template <class T, std::uint32_t kSlots = 4>
class Latest {
  static_assert(std::is_trivially_copyable_v<T>);
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

 public:
  static constexpr int kAttempts = 8;

  /// Writing thread only. Wait-free.
  void publish(const T& value) noexcept {
    std::uint32_t count = newest_.load(std::memory_order_relaxed) + 1;
    if (count == 0) count = kSlots;  // 0 means "none"; kSlots selects the same slot
    Slot& slot = slots_[count % kSlots];
    slot.filled_for.store(0, std::memory_order_relaxed);
    const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
    forEachWord([&](std::size_t i) {
      Word word;
      std::memcpy(&word, bytes + i * sizeof word, sizeof word);
      slot.words[i].store(word, std::memory_order_release);
    });
    if constexpr (kTail > 0) {
      Word word = 0;
      std::memcpy(&word, bytes + kWhole * sizeof word, kTail);
      slot.words[kWhole].store(word, std::memory_order_release);
    }
    slot.filled_for.store(count, std::memory_order_release);
    newest_.store(count, std::memory_order_release);
  }

  /// Any thread. True: `into` is the newest value. False: nothing was published yet, or (very rarely) the writer
  /// overwrote the slot in every attempt; `into` is then unchanged.
  [[nodiscard]] bool read(T& into) const noexcept {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const std::uint32_t count = newest_.load(std::memory_order_acquire);
      if (count == 0) return false;
      if (copy(slots_[count % kSlots], count, into)) return true;
    }
    return false;
  }

  /// For a reader that copies the whole object: offset of the publication count. A value read from the copy is
  /// consistent if the original's count, read after the copy, is at most kSafeLead above the copy's.
  static constexpr std::size_t offsetOfCount() noexcept { return offsetof(Latest, newest_); }
  static constexpr std::uint32_t kSafeLead = kSlots - 2;

  /// Number of publications, wrapping past 0. A change means a new value.
  [[nodiscard]] std::uint32_t count() const noexcept { return newest_.load(std::memory_order_acquire); }

 private:
  friend struct LatestForTests;
  using Word = std::uintptr_t;
  static_assert(std::atomic<Word>::is_always_lock_free);
  static constexpr std::size_t kWhole = sizeof(T) / sizeof(Word), kTail = sizeof(T) % sizeof(Word);
  static constexpr std::size_t kWords = kWhole + (kTail > 0 ? 1 : 0);

  /// Unrolled eight times: loop overhead costs as many instructions as copying one word.
  template <class F>
  static void forEachWord(F&& copy) noexcept {
    constexpr std::size_t kEights = kWhole / 8 * 8;
    const auto copy_four = [&](std::size_t j) { copy(j), copy(j + 1), copy(j + 2), copy(j + 3); };
    for (std::size_t i = 0; i < kEights; i += 8) copy_four(i), copy_four(i + 4);
    for (std::size_t i = kEights; i < kWhole; ++i) copy(i);
  }

  struct Slot {
    std::atomic<std::uint32_t> filled_for{0};
    std::array<std::atomic<Word>, kWords> words{};
  };

  static bool copy(const Slot& slot, std::uint32_t count, T& into) noexcept {
    std::array<Word, kWords> image;
    if (slot.filled_for.load(std::memory_order_acquire) != count) return false;
    forEachWord([&](std::size_t i) { image[i] = slot.words[i].load(std::memory_order_acquire); });
    if constexpr (kTail > 0) image[kWhole] = slot.words[kWhole].load(std::memory_order_acquire);
    if (slot.filled_for.load(std::memory_order_relaxed) != count) return false;
    std::memcpy(static_cast<void*>(&into), image.data(), sizeof(T));
    return true;
  }

  std::atomic<std::uint32_t> newest_{0};
  std::array<Slot, kSlots> slots_{};
};

}  // namespace darwinop::runtime
