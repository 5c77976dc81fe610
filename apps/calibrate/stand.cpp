#include "apps/calibrate/stand.hpp"

#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>

namespace darwinop::calibrate {

Held OwnersHands::hold(const TrunkPosture& posture) {
  instructions_ << '\n'
                << posture.instruction << ".\n  Enter when it is at rest; s and Enter: skip; q and Enter: end > "
                << std::flush;
  std::string answer;
  if (!std::getline(answers_, answer) || answer == "q") return Held::kEnded;
  return answer == "s" ? Held::kSkipped : Held::kHeld;
}

Held TwinClamp::hold(const TrunkPosture& posture) {
  if (!body_.clamp(posture.up))
    throw std::runtime_error("this simulated robot has no trunk to clamp; use --robot twin");
  return Held::kHeld;
}

}  // namespace darwinop::calibrate
