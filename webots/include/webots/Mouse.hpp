// Mouse in the simulator's window. This robot reads none.
#ifndef MOUSE_HPP
#define MOUSE_HPP

namespace webots {

/// What Mouse::getState() returns.
struct MouseState {
  bool left, middle, right;  // pressed
  double u, v;               // position in the window, 0 to 1; NaN: outside
  double x, y, z;            // position in the world, m; NaN: not known
};

/// A mouse outside of the window, as in simulation: no button is pressed and positions are NaN; the first use logs
/// one warning. Threads: see Robot.
class Mouse {
 public:
  /// Same as Robot::getMouse().
  Mouse() : period_(0), has_3d_(false) {}
  virtual ~Mouse() {}
  /// Absent here: stores `sampling_period` in ms.
  virtual void enable(int sampling_period);
  /// Absent here: sets the sampling period to 0.
  virtual void disable();
  /// ms as set last; 0: disabled.
  int getSamplingPeriod() const { return period_; }
  /// Absent here: stored only.
  virtual void enable3dPosition() { has_3d_ = true; }
  /// Absent here: stored only.
  virtual void disable3dPosition() { has_3d_ = false; }
  /// Whether enable3dPosition() was called last.
  bool is3dPositionEnabled() const { return has_3d_; }
  /// Absent here: no button is pressed, positions are NaN.
  MouseState getState() const;

 private:
  int period_;
  bool has_3d_;
};

}  // namespace webots

#endif
