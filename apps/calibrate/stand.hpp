// Brings the trunk into a posture and holds it: the owner's hands, or the clamp of a twin.
#pragma once

#include <cstdint>
#include <iosfwd>

#include "apps/calibrate/posture.hpp"
#include "hal/body.hpp"

namespace darwinop::calibrate {

enum class Held : std::uint8_t { kHeld, kSkipped, kEnded };

class Stand {
 public:
  virtual ~Stand() = default;
  virtual Held hold(const TrunkPosture& posture) = 0;
};

/// Says what to do with the hands and waits for Enter. "s" skips the posture, "q" or the end of the input ends.
class OwnersHands final : public Stand {
 public:
  OwnersHands(std::istream& answers, std::ostream& instructions) : answers_{answers}, instructions_{instructions} {}
  Held hold(const TrunkPosture& posture) override;

 private:
  std::istream& answers_;
  std::ostream& instructions_;
};

class TwinClamp final : public Stand {
 public:
  /// `body` must outlive it.
  explicit TwinClamp(Body& body) : body_{body} {}
  Held hold(const TrunkPosture& posture) override;

 private:
  Body& body_;
};

}  // namespace darwinop::calibrate
