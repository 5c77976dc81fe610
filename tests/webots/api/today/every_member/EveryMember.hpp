// Calls every class and method of the simulator's C++ API, of today and under earlier names.
#ifndef EVERY_MEMBER_HPP
#define EVERY_MEMBER_HPP

namespace webots {
  class Robot;
  class Supervisor;
}

// Each gets its devices by name and uses those that exist.
void useRobot(webots::Robot *robot);
void useMotors(webots::Robot *robot);
void useSensors(webots::Robot *robot);
void useCamera(webots::Robot *robot);
void useSpeaker(webots::Robot *robot);
void useInputs(webots::Robot *robot);
void useAbsentSensors(webots::Robot *robot);
void useAbsentActuators(webots::Robot *robot);
void useWorld(webots::Supervisor *supervisor);

#endif
