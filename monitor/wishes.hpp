// What an observer may ask for.
#pragma once

#include <optional>

#include "monitor/colour_search.hpp"

namespace darwinop::monitor {

inline constexpr double kMostRate = 125, kMostPictures = 30, kUsualRate = 20;  // Hz

struct Wishes {
  double rate = kUsualRate;  // state messages, Hz; 0: none
  double camera = 0;         // pictures, Hz; 0: none
  std::optional<Search> find = {};
  bool mask = false;  // with what is found: which pixels
  bool operator==(const Wishes&) const = default;
};

}  // namespace darwinop::monitor
