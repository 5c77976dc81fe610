// Walks as the arrow keys say, and gets up after a fall.
#ifndef WALK_HPP
#define WALK_HPP

#define NMOTORS 20

#include <webots/Robot.hpp>

namespace managers {
  class DARwInOPMotionManager;
  class DARwInOPGaitManager;
}

namespace webots {
  class Motor;
  class LED;
  class Accelerometer;
  class Gyro;
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
    managers::DARwInOPMotionManager *mMotionManager;
    managers::DARwInOPGaitManager *mGaitManager;
    bool mIsWalking;
};

#endif
