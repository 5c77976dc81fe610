// Walks as the arrow keys say, and gets up after a fall.
#ifndef WALK_HPP
#define WALK_HPP

#define NMOTORS 20

#include <webots/Robot.hpp>

namespace managers {
  class RobotisOp2MotionManager;
  class RobotisOp2GaitManager;
}

namespace webots {
  class Motor;
  class LED;
  class Accelerometer;
  class Gyro;
  class Keyboard;
  class PositionSensor;
}

class Walk : public webots::Robot {
  public:
    Walk();
    virtual ~Walk();
    void run();

  private:
    int mTimeStep;

    void myStep();
    void wait(int ms);

    void checkIfFallen();
    webots::Motor *mMotors[NMOTORS];
    webots::Accelerometer *mAccelerometer;
    webots::Gyro *mGyro;
    webots::Keyboard *mKeyboard;
    webots::PositionSensor *mSensors[NMOTORS];
    managers::RobotisOp2MotionManager *mMotionManager;
    managers::RobotisOp2GaitManager *mGaitManager;
    bool mIsWalking;
};

#endif
