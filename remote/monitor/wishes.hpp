// What an observer may ask for.
#pragma once

namespace darwinop::monitor {

inline constexpr double kMostRate = 125, kMostPictures = 30, kUsualRate = 20;  // Hz

struct Wishes {
  double rate = kUsualRate;  // state messages, Hz; 0: none
  double camera = 0;         // pictures, Hz; 0: none
  bool operator==(const Wishes&) const = default;
};

}  // namespace darwinop::monitor
