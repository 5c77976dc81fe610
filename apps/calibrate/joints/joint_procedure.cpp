#include "apps/calibrate/joints/joint_procedure.hpp"

#include <ostream>
#include <utility>

#include "apps/calibrate/joints/messages.hpp"

namespace darwinop::calibrate {

std::vector<GravityPoint> sweepJoints(std::unique_ptr<runtime::RobotLink> link, Stand& stand,
                                      const std::bitset<kJoints>& absent, const std::atomic<bool>& stop,
                                      std::ostream& log) {
  runtime::DriverSession session{std::move(link)};
  std::vector<GravityPoint> out;
  for (const TrunkPosture* const posture : sweepPostures()) {
    const Held held = stand.hold(*posture);
    if (held == Held::kEnded) break;
    if (held == Held::kSkipped) continue;
    log << posture->name << messages::kSweepBegins << std::endl;
    Sweeper sweeper{session, absent, stop};
    sweeper.moveTo(basePose());
    for (const std::bitset<kJoints>& round : rounds(sweptJoints(absent))) {
      const std::vector<GravityPoint> points = sweeper.sweep(round, posture->up);
      out.insert(out.end(), points.begin(), points.end());
    }
    sweeper.release();
    if (stop) return {};
    log << posture->name << ": swept\n";
  }
  return out;
}

}  // namespace darwinop::calibrate
