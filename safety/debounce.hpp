// Debouncing: conditions that must last before they count.
#pragma once

#include "safety/config.hpp"

namespace darwinop::safety {

/// On after `rise` of uninterrupted `set`, off after `fall` of uninterrupted `clear`. If neither is true (between two
/// thresholds), the state is kept. `set` and `clear` must not both be true.
class Debounce {
 public:
  constexpr Debounce(Nanos rise, Nanos fall) : rise_{rise}, fall_{fall} {}

  constexpr bool update(bool set, bool clear, Nanos dt) noexcept {
    if (!set && !on_) {  // nearly always
      set_for_ = Nanos{0};
      return false;
    }
    set_for_ = set ? set_for_ + dt : Nanos{0};
    clear_for_ = clear ? clear_for_ + dt : Nanos{0};
    if (!on_ && set && set_for_ >= rise_) on_ = true;
    if (on_ && clear && clear_for_ >= fall_) on_ = false;
    return on_;
  }
  [[nodiscard]] constexpr bool on() const noexcept { return on_; }
  constexpr void forget() noexcept { *this = Debounce{rise_, fall_}; }

 private:
  Nanos rise_, fall_;
  Nanos set_for_{0}, clear_for_{0};
  bool on_ = false;
};

/// On after two samples in a row, off after two in a row: one corrupted reading changes nothing. `set` and `clear` must
/// not both be true.
class Confirm {
 public:
  constexpr bool update(bool set, bool clear) noexcept {
    if (!set && !on_) {  // nearly always
      set_ = 0;
      return false;
    }
    set_ = set ? set_ + (set_ < 2 ? 1 : 0) : 0;
    clear_ = clear ? clear_ + (clear_ < 2 ? 1 : 0) : 0;
    if (set_ == 2) on_ = true;
    if (clear_ == 2) on_ = false;
    return on_;
  }
  [[nodiscard]] constexpr bool on() const noexcept { return on_; }
  /// One sample was `set`; the next one confirms or clears it.
  [[nodiscard]] constexpr bool suspected() const noexcept { return !on_ && set_ == 1; }
  constexpr void forget() noexcept { *this = Confirm{}; }

 private:
  int set_ = 0, clear_ = 0;
  bool on_ = false;
};

}  // namespace darwinop::safety
