// One call of the gait's engine, 8 ms of walking, and one of its peer.
#pragma once

#include <cmath>
#include <cstdlib>

#include "managers/gait/engine.hpp"
#include "plain_gait.hpp"

namespace darwinop::bench {

// Forwards, to the left and round: no amplitude is zero.
constexpr gait::WalkCommand kCommand{0.5, 0.25, 0.25, false};

class OurGait {
 public:
  OurGait() { engine_.start(); }
  const gait::Goals& call() { return engine_.next(kCommand, {std::nan(""), std::nan("")}); }

 private:
  gait::Engine engine_{gait::Parameters{}};
};

class PeersGait {
 public:
  PeersGait() { gait_.command(gait::kMaxX * kCommand.x, gait::kMaxY * kCommand.y, gait::kMaxA * kCommand.a); }
  const PlainGait::Ticks& call() { return gait_.next(); }

 private:
  PlainGait gait_;
};

/// Both give the same ticks, but for one where a fraction is cut off.
inline bool gaitsAreTheSame() {
  OurGait ours;
  PeersGait peers;
  for (int call = 0; call < 1000; ++call) {
    const auto& a = ours.call().tick;
    const auto& b = peers.call();
    for (std::size_t i = 0; i < a.size(); ++i)
      if (std::abs(a[i] - b[i]) > 1) return false;
  }
  return true;
}

}  // namespace darwinop::bench
