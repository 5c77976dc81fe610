// Walking: the robot moves to its stance, then steps with the given amplitudes until stop(). docs/gait.md
#ifndef DARWIN_OP_GAIT_MANAGER_HPP
#define DARWIN_OP_GAIT_MANAGER_HPP

#include <string>

namespace webots {
class Robot;
}

namespace managers {

///     managers::DARwInOPGaitManager gait(&robot, "config.ini");
///     gait.setXAmplitude(1);                    // forwards
///     gait.start();
///     while (robot.getTime() < 15) {
///       gait.step(16);                          // before each step of the robot, with the same duration
///       if (robot.step(16) == -1) return 1;
///     }
///     gait.stop();                              // blocks until the robot stands
///
/// Sets goals, speed limits and P gains of joints 1 to 18 (all but the head) from start() until stop() has returned,
/// and at no other time. Goals never exceed 12.26 rad/s or the joint ranges, and pass through the safety layer. One
/// object walks at a time; while a motion page is played it has the joints, and the walk restarts from the stance
/// afterwards. While the robot does not follow, as with a silent board or a lost connection, the walk waits. After
/// 0.3 s it is over, with one message; once the robot follows, it restarts from the robot's pose unless stop() was
/// called.
///
/// A session that ends during a walk, by Ctrl-C, exit(), an exception or the end of main(), finishes its steps first,
/// in 2.2 s at most by default, so that the robot kneels from both feet; so does the destructor. `kill -9` cannot.
///
/// Tried in the physics twin only, never on a robot. Simulator and 2013: the same engine, tick for tick. Errors are
/// logged once on stderr, nothing is thrown. Threads: all calls from the thread of the Robot.
class DARwInOPGaitManager {
 public:
  /// Enables the gyroscope and reads section [Walking Config] of the file; a relative name starts at the directory of
  /// the program. A missing file gives the defaults. A wrong value is logged with file and line, and the robot will not
  /// walk.
  DARwInOPGaitManager(webots::Robot* robot, const std::string& iniFilename);
  /// The same robot, parameters and amplitudes; the copy stands still until its start().
  DARwInOPGaitManager(const DARwInOPGaitManager& other);
  /// As the copy constructor; what this object was doing ends.
  DARwInOPGaitManager& operator=(const DARwInOPGaitManager& other);
  virtual ~DARwInOPGaitManager();
  /// False: there is no robot, or the file has a wrong value; every call then does nothing.
  bool isCorrectlyInitialized();

  // Amplitudes apply from the middle of the next step. They are clamped to -1 to 1, default 0; NaN is ignored with a
  // warning.

  /// Forwards, -1 to 1; 1 is an amplitude of 20 mm.
  void setXAmplitude(double x);
  /// To the left, -1 to 1; 1 is an amplitude of 40 mm.
  void setYAmplitude(double y);
  /// Turn to the left, -1 to 1; 1 is an amplitude of 50 degrees.
  void setAAmplitude(double a);
  /// True: a turn circles around a point in front of the robot and keeps facing it. Default false.
  void setMoveAimOn(bool on);
  /// True (default): the gyroscope corrects knees, ankles and hips. It is calibrated once while the robot stands still
  /// for 1.6 s: in calls of step() before start(), else after the robot has reached its stance. If the robot moves
  /// meanwhile it walks without balance, with one warning.
  void setBalanceEnable(bool on);

  /// Parameters of the walk under the names of section [Walking Config], with their ranges; defaults: docs/gait.md.
  struct GaitParameters {
    /// The defaults.
    GaitParameters();
    double x_offset;                  ///< both feet forwards: -60 to 60 mm
    double y_offset;                  ///< feet apart, half of it each: -20 to 100 mm
    double z_offset;                  ///< crouching: 5 to 80 mm
    double roll_offset;               ///< soles rolled inwards or outwards, half of it each: -30 to 30 degrees
    double pitch_offset;              ///< soles pitched: -30 to 30 degrees
    double yaw_offset;                ///< feet turned outwards, half of it each: -60 to 60 degrees
    double hip_pitch_offset;          ///< trunk leans forwards: -30 to 45 degrees
    double period_time;               ///< two steps: 240 to 3000 ms
    double dsp_ratio;                 ///< share of the period with both feet down: 0 to 0.8, no unit
    double step_forward_back_ratio;   ///< swing of the body forwards, as a share of the step: -1 to 1, no unit
    double foot_height;               ///< lift of a foot: 0 to 80 mm
    double swing_right_left;          ///< swing of the body to the sides: 0 to 60 mm
    double swing_top_down;            ///< swing of the body up and down: 0 to 30 mm
    double pelvis_offset;             ///< extra hip roll on one foot: -15 to 15 degrees
    double arm_swing_gain;            ///< swing of the arms: -5 to 5 degrees a mm of step
    double balance_knee_gain;         ///< gyroscope to knees: 0 to 5, no unit
    double balance_ankle_pitch_gain;  ///< gyroscope to ankle pitch: 0 to 5, no unit
    double balance_hip_roll_gain;     ///< gyroscope to hip roll: 0 to 5, no unit
    double balance_ankle_roll_gain;   ///< gyroscope to ankle roll: 0 to 5, no unit
    double p_gain;                    ///< stiffness of the legs: 8 to 254 register value; 8 is Kp = 1
  };
  /// The parameters of the last setParameters(); before it those of the file. Neither the simulator nor 2013 has this.
  GaitParameters getParameters() const;
  /// Changes the walk while the program runs: applied between two steps, when both feet are down (every half
  /// period_time ms, 300 by default), and from the next stance on if the robot does not walk. False and one warning,
  /// without any change, if one value is out of its range or NaN, or if the manager is not initialized. Goals stay
  /// limited to 12.26 rad/s, but a large change of offsets can make a walking robot fall: change them a little at a
  /// time. Neither the simulator nor 2013 has this.
  bool setParameters(const GaitParameters& parameters);

  /// From the next step() on the robot moves to its stance at 0.75 rad/s at most, and then walks. Does not block.
  void start();
  /// Call it before every Robot::step(), with the same duration in ms, 8 or more, best a multiple of 8. Computes the
  /// goals that are due, one every 8 ms; the remainder is carried over. Under 8 ms it does nothing, with one warning;
  /// more than 10000 ms count as 10000. Does not block.
  /// If more of the robot's time has passed since the last call, the walk keeps it in whole ticks, up to 80 ms a call;
  /// one message then names the time of a round and the step that fits. In slow rounds it walks without balance (over
  /// 52 ms) and with 0.7 of the amplitudes (over 68 ms). A pause of more than 1 s counts as `ms`. A controller that
  /// never calls it walks by its Robot::step(), as on the robot, where a thread walked.
  void step(int ms);
  /// Finishes the current steps and returns when the robot stands in its stance. Until then it calls Robot::step() with
  /// the basic time step: 1.5 gait periods at most (0.9 s by default), or the rest of the way to the stance. Returns at
  /// once when Robot::step() returns -1, and in any pose when the robot has not followed for 0.3 s.
  void stop();

 private:
  struct Walker;
  Walker* walker_;  // never NULL
};

}  // namespace managers

#endif
