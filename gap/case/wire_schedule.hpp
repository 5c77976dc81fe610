// When in a cycle the runtime wrote the goals and read each servo, from the bytes on the wire.
#pragma once

#include <span>
#include <vector>

#include "experiments/logs/log.hpp"
#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Bytes of the runtime's bulk read, and the time of one; tests hold them against hal/cm730/wire.hpp.
namespace wire {
inline constexpr double kByte = 1e-5;               // s, at 1 Mbaud
inline constexpr double kOfBoard = 36, kOfTag = 4;  // reply of the board, and up to so many bytes more
inline constexpr double kOfServo = 12, kOfPolled = 26;
inline constexpr double kOfRequest = 10, kOfRequestEach = 3;  // with the board, and of each servo
}  // namespace wire

/// Of one cycle, s after it began: when its goals were written, and when board and servos were read, in the order of
/// ids.
struct CycleSchedule {
  double written_s = 0, board_s = 0;
  std::vector<double> servo_s;
};
/// `total_bytes`: written and read in this cycle; NaN: not known. `replies`: bytes of each servo's; 0: it did not
/// reply.
CycleSchedule cycleSchedule(double total_bytes, std::span<const double> replies);

/// Fills written_s and read_s of the joints of one recording. Nothing where the file does not have `bus.wire`: rows are
/// then read before their goals are written. A joint that never answers has no servo, as `absent` of robot.ini says.
void fillWireSchedule(const logs::Log& recording, std::span<Trajectory> joints);

/// The simulated robot of a lockstep run: its servos' firmware runs in step with the loop. Else the phase of a servo's
/// firmware is not known.
bool isInLockstep(const logs::Log& recording);

}  // namespace darwinop::gap
