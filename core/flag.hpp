// Boolean of one byte for which every bit pattern is valid.
#pragma once

#include <cstdint>
#include <type_traits>

namespace darwinop {

/// For data in memory that another process writes: loading a bool from a byte other than 0 or 1 is undefined behaviour.
/// Here every byte but 0 reads as true.
class Flag {
 public:
  constexpr Flag() = default;
  constexpr Flag(bool on) : raw_{on ? std::uint8_t{1} : std::uint8_t{0}} {}  // NOLINT: stands for a bool
  constexpr operator bool() const { return raw_ != 0; }                      // NOLINT: stands for a bool
  constexpr Flag& operator|=(bool on) { return *this = *this || on; }

 private:
  std::uint8_t raw_ = 0;
};
static_assert(sizeof(Flag) == 1 && std::is_trivially_copyable_v<Flag>);

}  // namespace darwinop
