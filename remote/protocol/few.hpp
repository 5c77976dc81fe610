// Fixed-capacity list without heap.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace darwinop::remote {

template <class T, std::size_t N>
class Few {
 public:
  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }
  [[nodiscard]] static constexpr std::size_t most() { return N; }
  [[nodiscard]] constexpr const T* begin() const { return items_.data(); }
  [[nodiscard]] constexpr const T* end() const { return items_.data() + size_; }
  [[nodiscard]] constexpr const T& operator[](std::size_t i) const { return items_[i]; }
  /// False if the list is full; nothing is added then.
  constexpr bool add(const T& item) {
    if (size_ == N) return false;
    items_[size_++] = item;
    return true;
  }
  constexpr bool operator==(const Few& other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

 private:
  std::array<T, N> items_{};
  std::size_t size_ = 0;
};

}  // namespace darwinop::remote
