// Devices of other robots: each is used if it exists, and so is an object of a class of the controller's own.
#include "EveryMember.hpp"

#include <webots/Altimeter.hpp>
#include <webots/Brake.hpp>
#include <webots/Compass.hpp>
#include <webots/Connector.hpp>
#include <webots/Display.hpp>
#include <webots/DistanceSensor.hpp>
#include <webots/Emitter.hpp>
#include <webots/GPS.hpp>
#include <webots/ImageRef.hpp>
#include <webots/InertialUnit.hpp>
#include <webots/Lidar.hpp>
#include <webots/LightSensor.hpp>
#include <webots/Pen.hpp>
#include <webots/Radar.hpp>
#include <webots/RangeFinder.hpp>
#include <webots/Receiver.hpp>
#include <webots/Robot.hpp>
#include <webots/Skin.hpp>
#include <webots/VacuumGripper.hpp>

using namespace webots;
using namespace std;

template<class T> static void sample(T *sensor) {
  sensor->enable(16);
  sensor->getSamplingPeriod();
  sensor->disable();
}

static void use(Altimeter *altimeter) {
  sample(altimeter);
  altimeter->getValue();
}

static void use(Compass *compass) {
  sample(compass);
  compass->getValues();
  compass->getLookupTableSize();
  compass->getLookupTable();
}

static void use(DistanceSensor *distance) {
  sample(distance);
  distance->getValue();
  distance->getMaxValue();
  distance->getMinValue();
  distance->getAperture();
  distance->getLookupTableSize();
  distance->getLookupTable();
  const DistanceSensor::Type type = distance->getType();
  if (type == DistanceSensor::GENERIC || type == DistanceSensor::INFRA_RED || type == DistanceSensor::SONAR ||
      type == DistanceSensor::LASER)
    return;
}

static void use(GPS *gps) {
  sample(gps);
  gps->getValues();
  gps->getSpeed();
  gps->getSpeedVector();
  if (gps->getCoordinateSystem() == GPS::WGS84 || gps->getCoordinateSystem() == GPS::LOCAL)
    return;
}

static void use(InertialUnit *unit) {
  sample(unit);
  unit->getRollPitchYaw();
  unit->getQuaternion();
  unit->getNoise();
  unit->getLookupTableSize();
  unit->getLookupTable();
}

static void use(Lidar *lidar) {
  sample(lidar);
  lidar->enablePointCloud();
  lidar->isPointCloudEnabled();
  lidar->getRangeImage();
  lidar->getLayerRangeImage(0);
  const LidarPoint *points = lidar->getPointCloud();
  const LidarPoint *layer = lidar->getLayerPointCloud(0);
  if (lidar->getNumberOfPoints() > 0 && points[0].x + points[0].y + points[0].z + points[0].time > layer[0].layer_id)
    return;
  lidar->getHorizontalResolution();
  lidar->getNumberOfLayers();
  lidar->getMinFrequency();
  lidar->getMaxFrequency();
  lidar->setFrequency(lidar->getFrequency());
  lidar->getFov();
  lidar->getVerticalFov();
  lidar->getMinRange();
  lidar->getMaxRange();
  lidar->disablePointCloud();
}

static void use(LightSensor *light) {
  sample(light);
  light->getValue();
  light->getLookupTableSize();
  light->getLookupTable();
}

static void use(Radar *radar) {
  sample(radar);
  radar->getMinRange();
  radar->getMaxRange();
  radar->getHorizontalFov();
  radar->getVerticalFov();
  const RadarTarget *targets = radar->getTargets();
  for (int i = 0; i < radar->getNumberOfTargets(); ++i)
    if (targets[i].distance + targets[i].received_power + targets[i].speed + targets[i].azimuth < 0)
      return;
}

static void use(RangeFinder *finder) {
  sample(finder);
  const float *image = finder->getRangeImage();
  RangeFinder::rangeImageGetDepth(image, finder->getWidth(), 0, finder->getHeight() - 1);
  finder->getFov();
  finder->getMinRange();
  finder->getMaxRange();
  finder->saveImage("depth.png", 100);
}

static void use(Receiver *receiver) {
  sample(receiver);
  receiver->setChannel(Receiver::CHANNEL_BROADCAST);
  receiver->getChannel();
  while (receiver->getQueueLength() > 0) {
    receiver->getData();
    receiver->getDataSize();
    receiver->getSignalStrength();
    receiver->getEmitterDirection();
    receiver->nextPacket();
  }
}

static void use(Brake *brake) {
  brake->setDampingConstant(1);
  brake->getMotor();
  brake->getPositionSensor();
  if (brake->getType() == Brake::ROTATIONAL || brake->getType() == Brake::LINEAR)
    return;
}

static void use(Connector *connector) {
  connector->enablePresence(16);
  connector->getPresenceSamplingPeriod();
  connector->getPresence();
  connector->lock();
  connector->isLocked();
  connector->unlock();
  connector->disablePresence();
}

static void use(Display *display) {
  const int x[] = {0, 1, 2}, y[] = {0, 2, 1};
  display->getWidth();
  display->getHeight();
  display->setColor(0xFF0000);
  display->setAlpha(1);
  display->setOpacity(1);
  display->setFont("Arial", 12, true);
  display->drawPixel(0, 0);
  display->drawLine(0, 0, 1, 1);
  display->drawRectangle(0, 0, 1, 1);
  display->drawOval(5, 5, 2, 2);
  display->drawPolygon(x, y, 3);
  display->drawText("text", 0, 0);
  display->fillRectangle(0, 0, 1, 1);
  display->fillOval(5, 5, 2, 2);
  display->fillPolygon(x, y, 3);
  ImageRef *image = display->imageNew(1, 1, "\x01\x02\x03", Display::RGB);
  ImageRef *copy = display->imageCopy(0, 0, 1, 1);
  display->imageDelete(display->imageLoad("picture.png"));
  display->imagePaste(image, 0, 0);
  display->imagePaste(copy, 0, 0, true);
  display->imageSave(NULL, "display.png");
  display->imageNew(1, 1, "\x01\x02\x03\x04", Display::RGBA + 0 * (Display::ARGB + Display::BGRA + Display::ABGR));
  display->attachCamera(NULL);
  display->detachCamera();
}

static void use(Emitter *emitter) {
  emitter->setChannel(Emitter::CHANNEL_BROADCAST);
  emitter->getChannel();
  emitter->setRange(-1);
  emitter->getRange();
  emitter->getBufferSize();
  if (emitter->send("text", 5) == 0)
    return;
}

static void use(Pen *pen) {
  pen->write(true);
  pen->setInkColor(0xFF0000, 0.5);
}

static void use(Skin *skin) {
  if (skin->getBoneCount() > 0) {
    skin->getBoneName(0);
    skin->setBoneOrientation(0, skin->getBoneOrientation(0, true), true);
    skin->setBonePosition(0, skin->getBonePosition(0, false), false);
  }
}

static void use(VacuumGripper *gripper) {
  gripper->enablePresence(16);
  gripper->getPresenceSamplingPeriod();
  gripper->getPresence();
  gripper->turnOn();
  gripper->isOn();
  gripper->turnOff();
  gripper->disablePresence();
}

// getValues() of the simulator is not virtual: a class may have another one.
template<class T> class Own : public T {
  public:
    Own(const string &name) : T(name) {}
    string getValues() const { return T::getName(); }
};

template<class T> static void useBoth(T *ofTheRobot) {
  if (ofTheRobot != NULL)
    use(ofTheRobot);
  Own<T> *own = new Own<T>("own");
  use(own);
  if (own->getValues() == "own")
    delete own;
}

void useAbsentSensors(Robot *robot) {
  useBoth(robot->getAltimeter("altimeter"));
  useBoth(robot->getCompass("compass"));
  useBoth(robot->getDistanceSensor("ds0"));
  useBoth(robot->getGPS("gps"));
  useBoth(robot->getInertialUnit("inertial unit"));
  useBoth(robot->getLidar("lidar"));
  useBoth(robot->getLightSensor("light"));
  useBoth(robot->getRadar("radar"));
  useBoth(robot->getRangeFinder("range-finder"));
  useBoth(robot->getReceiver("receiver"));
  const string angle = GPS::convertToDegreesMinutesSeconds(12.5);
}

void useAbsentActuators(Robot *robot) {
  useBoth(robot->getBrake("brake"));
  useBoth(robot->getConnector("connector"));
  useBoth(robot->getDisplay("display"));
  useBoth(robot->getEmitter("emitter"));
  useBoth(robot->getPen("pen"));
  useBoth(robot->getSkin("skin"));
  useBoth(robot->getVacuumGripper("gripper"));
}
