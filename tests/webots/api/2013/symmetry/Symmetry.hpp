// Left arm mirrors the limp right arm.
#ifndef SYMMETRY_HPP
#define SYMMETRY_HPP

#define NMOTORS 20

#include <webots/Robot.hpp>

namespace webots {
  class Motor;
  class LED;
  class Speaker;
}

class Symmetry : public webots::Robot {
  public:
    Symmetry();
    virtual ~Symmetry();
    void run();

  private:
    int mTimeStep;

    void myStep();
    void wait(int ms);

    webots::Motor *mMotors[NMOTORS];
    webots::LED *mEyeLED, *mHeadLED;
    webots::Speaker *mSpeaker;
    double mMin[NMOTORS], mMax[NMOTORS];
};

#endif
