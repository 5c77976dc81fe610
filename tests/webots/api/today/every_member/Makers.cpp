// Makers of devices: protected members, for a class of the controller's own. Compiled only: a process has one robot.
#include <webots/Robot.hpp>

using namespace webots;
using namespace std;

class EveryMaker : public Robot {
  public:
    void use(const string &name);
};

void EveryMaker::use(const string &name) {
  createAccelerometer(name);
  createAltimeter(name);
  createBrake(name);
  createCamera(name);
  createCompass(name);
  createConnector(name);
  createDisplay(name);
  createDistanceSensor(name);
  createEmitter(name);
  createGPS(name);
  createGyro(name);
  createInertialUnit(name);
  createLED(name);
  createLidar(name);
  createLightSensor(name);
  createMotor(name);
  createPen(name);
  createPositionSensor(name);
  createRadar(name);
  createRangeFinder(name);
  createReceiver(name);
  createServo(name);
  createSkin(name);
  createSpeaker(name);
  createTouchSensor(name);
  createVacuumGripper(name);
}
