// What only a longer observation shows: another program on the port, a loose connector, noise, restarts of the board or
// of servos, ids of no servo. For the doctor; a start of a loop does not wait for it.
#pragma once

#include "hal/byte_line.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

/// Receives for 0.2 s without a request and counts valid frames: replies to requests of another program. What arrives
/// in the first 30 ms is discarded: it may answer the last request of this one.
void countForeignFrames(ByteLine& line, RobotFacts& facts);

/// Ends a burst of losses that a single damaged length byte causes: after two losses in a row the board is asked, and
/// if it is silent as well, devices get the time to discard their frame.
class LossBurst {
 public:
  void note(ByteLine& line, RobotFacts& facts, bool answered);

 private:
  int in_a_row_ = 0;
};

/// Reads for at least 1.5 s: whole tables of the readable servos, pings of the silent ones, servo power, torque; then
/// pings unused ids if servos are silent. Servo power that has gone off is switched on again; nothing else is written.
/// Slower events are missed: what resets a board every few seconds looks healthy.
void observe(ByteLine& line, RobotFacts& facts);

}  // namespace darwinop::cm730
