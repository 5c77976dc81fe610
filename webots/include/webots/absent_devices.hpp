// Device classes of the simulator's API that this robot does not have: the one table of them, and their common base.
#ifndef ABSENT_DEVICES_HPP
#define ABSENT_DEVICES_HPP

#include <webots/Device.hpp>

// One row per class with a getter Robot::getCLASS(name). A new row needs the header webots/CLASS.hpp, an abstract
// class: no object of it exists, so there is nothing to implement, and a controller that uses one compiles and links.
#define DARWINOP_ABSENT_DEVICES(ROW) \
  ROW(Altimeter)                     \
  ROW(Brake)                         \
  ROW(Compass)                       \
  ROW(Connector)                     \
  ROW(Display)                       \
  ROW(DistanceSensor)                \
  ROW(Emitter)                       \
  ROW(GPS)                           \
  ROW(InertialUnit)                  \
  ROW(Lidar)                         \
  ROW(LightSensor)                   \
  ROW(Pen)                           \
  ROW(Radar)                         \
  ROW(RangeFinder)                   \
  ROW(Receiver)                      \
  ROW(Skin)                          \
  ROW(VacuumGripper)

namespace webots {

/// Calls that all sensors of the simulator have. No object exists here: Robot's getters return NULL.
class AbsentSensor : public Device {
 public:
  /// Starts measuring every `sampling_period` ms.
  virtual void enable(int sampling_period) = 0;
  /// Ends measuring.
  virtual void disable() = 0;
  /// ms as set last; 0: disabled.
  virtual int getSamplingPeriod() const = 0;
};

}  // namespace webots

#endif
