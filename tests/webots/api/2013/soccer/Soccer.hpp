// Looks for a ball, walks to it, kicks it.
#ifndef SOCCER_HPP
#define SOCCER_HPP

#define NMOTORS 20

#include <webots/Robot.hpp>

namespace managers {
  class DARwInOPMotionManager;
  class DARwInOPGaitManager;
  class DARwInOPVisionManager;
}

namespace webots {
  class Motor;
  class LED;
  class Camera;
  class Accelerometer;
  class Gyro;
  class Speaker;
}

class Soccer : public webots::Robot {
  public:
    Soccer();
    virtual ~Soccer();
    void run();

  private:
    int mTimeStep;

    void myStep();
    void wait(int ms);

    bool getBallCenter(double &x, double &y);
    webots::Motor *mMotors[NMOTORS];
    webots::LED *mEyeLED, *mHeadLED, *mBackLedRed, *mBackLedGreen, *mBackLedBlue;
    webots::Camera *mCamera;
    webots::Accelerometer *mAccelerometer;
    webots::Gyro *mGyro;
    double mMin[NMOTORS], mMax[NMOTORS];
    managers::DARwInOPMotionManager *mMotionManager;
    managers::DARwInOPGaitManager *mGaitManager;
    managers::DARwInOPVisionManager *mVisionManager;
};

#endif
