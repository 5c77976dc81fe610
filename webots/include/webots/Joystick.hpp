// Joystick of the person at the simulator. This robot reads none.
#ifndef JOYSTICK_HPP
#define JOYSTICK_HPP

#include <string>

namespace webots {

/// A joystick that is not connected, as in simulation without one: calls have no effect; the first use logs one
/// warning. Threads: see Robot.
class Joystick {
 public:
  /// Same as Robot::getJoystick().
  Joystick() : period_(0) {}
  virtual ~Joystick() {}
  /// Absent here: stores `sampling_period` in ms.
  virtual void enable(int sampling_period);
  /// Absent here: sets the sampling period to 0.
  virtual void disable();
  /// ms as set last; 0: disabled.
  int getSamplingPeriod() const { return period_; }
  /// Absent here: false.
  bool isConnected() const { return false; }
  /// Absent here: empty.
  std::string getModel() const { return std::string(); }
  /// Absent here: 0. Number of axes.
  int getNumberOfAxes() const { return 0; }
  /// Absent here: 0. Simulator: -32768 to 32767.
  int getAxisValue(int axis) const;
  /// Absent here: 0. Number of direction pads.
  int getNumberOfPovs() const { return 0; }
  /// Absent here: 0. Simulator: bits of directions, 0 to 15.
  int getPovValue(int pov) const;
  /// Absent here: -1, no button. Simulator: Number of a pressed button.
  int getPressedButton() const { return -1; }
  /// Absent here: no effect; no unit.
  void setConstantForce(int level);
  /// Absent here: no effect; s.
  void setConstantForceDuration(double duration);
  /// Absent here: no effect; no unit.
  void setAutoCenteringGain(double gain);
  /// Absent here: no effect; no unit.
  void setResistanceGain(double gain);
  /// Absent here: no effect; no unit.
  void setForceAxis(int axis);

 private:
  int period_;
};

}  // namespace webots

#endif
