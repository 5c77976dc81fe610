// Device classes of the simulator's API that this robot does not have: the one table of them, and their common base.
#ifndef ABSENT_DEVICES_HPP
#define ABSENT_DEVICES_HPP

#include <webots/Device.hpp>

// One row per class with a getter Robot::getCLASS(name). A new row needs the header webots/CLASS.hpp, whose methods
// return what means absent: numbers NaN, pointers NULL, counts and lists of nothing 0. As in the simulator, only what
// is not const is virtual: a class of a controller's own may have another getValues().
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

namespace darwinop {
namespace webots_api {

/// NaN: what an absent device measures.
double absentNumber();

/// Four of them, for vectors and rotations. Valid for ever.
const double* absentNumbers();

}  // namespace webots_api
}  // namespace darwinop

namespace webots {

/// Calls that all sensors of the simulator have.
class AbsentSensor : public Device {
 public:
  /// Absent here: stores `sampling_period` in ms.
  virtual void enable(int sampling_period) { period_ = sampling_period; }
  /// Absent here: sets the sampling period to 0.
  virtual void disable() { period_ = 0; }
  /// ms as set last; 0: disabled.
  int getSamplingPeriod() const { return period_; }

 protected:
  /// As Device.
  AbsentSensor(const std::string& name, const char* type) : Device(name, type), period_(0) {}

 private:
  int period_;
};

}  // namespace webots

#endif
