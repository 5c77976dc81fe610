// The head follows a ball.
#ifndef VISUAL_TRACKING_HPP
#define VISUAL_TRACKING_HPP

#define NMOTORS 20

#include <webots/Robot.hpp>

namespace managers {
  class RobotisOp2VisionManager;
}

namespace webots {
  class Motor;
  class LED;
  class Camera;
}

class VisualTracking : public webots::Robot {
  public:
    VisualTracking();
    virtual ~VisualTracking();
    void run();

  private:
    int mTimeStep;

    void myStep();
    void wait(int ms);

    webots::Motor *mMotors[NMOTORS];
    webots::LED *mEyeLED, *mHeadLED;
    webots::Camera *mCamera;
    managers::RobotisOp2VisionManager *mVisionManager;
};

#endif
