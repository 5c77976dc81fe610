// What an observer subscribes to.
#pragma once

#include <optional>

#include "monitor/colour_search.hpp"

namespace darwinop::monitor {

inline constexpr double kMostRate = 125, kMostPictures = 30, kUsualRate = 20;  // Hz

struct Subscription {
  double rate = kUsualRate;  // state messages, Hz; 0: none
  double camera = 0;         // pictures, Hz; 0: none
  std::optional<ColourQuery> find = {};
  bool mask = false;  // results include the mask of matching pixels
  bool operator==(const Subscription&) const = default;
};

}  // namespace darwinop::monitor
