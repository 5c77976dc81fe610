// Device classes of the controller's own, made by the robot and by new.
#include <cstdlib>

#include <webots/Accelerometer.hpp>
#include <webots/Camera.hpp>
#include <webots/Compass.hpp>
#include <webots/Emitter.hpp>
#include <webots/GPS.hpp>
#include <webots/Gyro.hpp>
#include <webots/LED.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Robot.hpp>
#include <webots/Servo.hpp>
#include <webots/Speaker.hpp>
#include <webots/TouchSensor.hpp>

using namespace webots;
using namespace std;

class Joint : public Servo {
  public:
    Joint(const string &name) : Servo(name), mTarget(0) {}
    void moveTo(double target) {
      mTarget = target;
      setPosition(target);
    }
    virtual void setPosition(double position) { Servo::setPosition(position < mTarget ? position : mTarget); }

  private:
    double mTarget;
};

class Lamp : public LED {
  public:
    Lamp(const string &name) : LED(name) {}
    void blink() { set(get() == 0 ? 0xFF0000 : 0); }
};

// Of devices that the robot lacks.
class North : public Compass {
  public:
    North(const string &name) : Compass(name) {}
    bool isKnown() const { return getValues()[0] == getValues()[0]; }
};

class Place : public GPS {
  public:
    Place(const string &name) : GPS(name) {}
    string getValues() const { return GPS::getValues()[0] < 1 ? "here" : "nowhere"; }
};

class OwnDevices : public Robot {
  public:
    OwnDevices() {
      mNeck = dynamic_cast<Joint *>(getServo("Neck"));
      mLamp = static_cast<Lamp *>(getLED("HeadLed"));
      mHead = new Joint("Head");
      mNorth = dynamic_cast<North *>(getCompass("compass"));
      mNorth->enable(getBasicTimeStep());
      mEmitter = new Emitter("emitter");
      mPlace = new Place("gps");
    }
    virtual ~OwnDevices() {
      delete mHead;
      delete mEmitter;
      delete mPlace;
    }
    void run() {
      Accelerometer accelerometer("Accelerometer");
      Gyro gyro("Gyro");
      PositionSensor position("HeadS");
      TouchSensor button("ButtonStart");
      Camera camera("Camera");
      Speaker speaker("Speaker");
      const double *values = gyro.getValues();
      while (step(getBasicTimeStep()) != -1) {
        if (mNorth->isKnown() || mPlace->getValues() == "here" || mEmitter->send("text", 5) == 1)
          exit(EXIT_FAILURE);
        mLamp->blink();
        mNeck->moveTo(0.2);
        mHead->moveTo(values[0] > 0 && accelerometer.getValues()[2] > 0 && button.getValue() == 0 ? 0.1 : position.getValue());
      }
    }

  protected:
    virtual Servo *createServo(const string &name) const { return new Joint(name); }
    virtual LED *createLED(const string &name) const { return new Lamp(name); }
    virtual Camera *createCamera(const string &name) const { return Robot::createCamera(name); }
    virtual Compass *createCompass(const string &name) const { return new North(name); }

  private:
    Joint *mNeck, *mHead;
    Lamp *mLamp;
    North *mNorth;
    Emitter *mEmitter;
    Place *mPlace;
};

int main() {
  OwnDevices *controller = new OwnDevices();
  controller->run();
  delete controller;
  return EXIT_SUCCESS;
}
