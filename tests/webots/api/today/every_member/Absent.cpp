// Devices of other robots: each is used if it exists.
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

template<class T> static bool started(T *sensor) {
  if (sensor == NULL)
    return false;
  sensor->enable(16);
  sensor->getSamplingPeriod();
  sensor->disable();
  return true;
}

void useAbsentSensors(Robot *robot) {
  Altimeter *altimeter = robot->getAltimeter("altimeter");
  if (started(altimeter))
    altimeter->getValue();

  Compass *compass = robot->getCompass("compass");
  if (started(compass)) {
    compass->getValues();
    compass->getLookupTableSize();
    compass->getLookupTable();
  }

  DistanceSensor *distance = robot->getDistanceSensor("ds0");
  if (started(distance)) {
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

  GPS *gps = robot->getGPS("gps");
  if (started(gps)) {
    gps->getValues();
    gps->getSpeed();
    gps->getSpeedVector();
    if (gps->getCoordinateSystem() == GPS::WGS84 || gps->getCoordinateSystem() == GPS::LOCAL)
      return;
  }
  const string angle = GPS::convertToDegreesMinutesSeconds(12.5);

  InertialUnit *unit = robot->getInertialUnit("inertial unit");
  if (started(unit)) {
    unit->getRollPitchYaw();
    unit->getQuaternion();
    unit->getNoise();
    unit->getLookupTableSize();
    unit->getLookupTable();
  }

  Lidar *lidar = robot->getLidar("lidar");
  if (started(lidar)) {
    lidar->enablePointCloud();
    lidar->isPointCloudEnabled();
    lidar->getRangeImage();
    lidar->getLayerRangeImage(0);
    const LidarPoint *points = lidar->getPointCloud();
    const LidarPoint *layer = lidar->getLayerPointCloud(0);
    if (points[0].x + points[0].y + points[0].z + points[0].time > layer[0].layer_id)
      return;
    lidar->getNumberOfPoints();
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

  LightSensor *light = robot->getLightSensor("light");
  if (started(light)) {
    light->getValue();
    light->getLookupTableSize();
    light->getLookupTable();
  }

  Radar *radar = robot->getRadar("radar");
  if (started(radar)) {
    radar->getMinRange();
    radar->getMaxRange();
    radar->getHorizontalFov();
    radar->getVerticalFov();
    const RadarTarget *targets = radar->getTargets();
    for (int i = 0; i < radar->getNumberOfTargets(); ++i)
      if (targets[i].distance + targets[i].received_power + targets[i].speed + targets[i].azimuth < 0)
        return;
  }

  RangeFinder *finder = robot->getRangeFinder("range-finder");
  if (started(finder)) {
    const float *image = finder->getRangeImage();
    RangeFinder::rangeImageGetDepth(image, finder->getWidth(), 0, finder->getHeight() - 1);
    finder->getFov();
    finder->getMinRange();
    finder->getMaxRange();
    finder->saveImage("depth.png", 100);
  }

  Receiver *receiver = robot->getReceiver("receiver");
  if (started(receiver)) {
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
}

static void draw(Display *display) {
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

void useAbsentActuators(Robot *robot) {
  Brake *brake = robot->getBrake("brake");
  if (brake != NULL) {
    brake->setDampingConstant(1);
    if (brake->getType() == Brake::ROTATIONAL || brake->getType() == Brake::LINEAR)
      return;
    brake->getMotor();
    brake->getPositionSensor();
  }

  Connector *connector = robot->getConnector("connector");
  if (connector != NULL) {
    connector->enablePresence(16);
    connector->getPresenceSamplingPeriod();
    connector->getPresence();
    connector->lock();
    connector->isLocked();
    connector->unlock();
    connector->disablePresence();
  }

  Display *display = robot->getDisplay("display");
  if (display != NULL)
    draw(display);

  Emitter *emitter = robot->getEmitter("emitter");
  if (emitter != NULL) {
    emitter->setChannel(Emitter::CHANNEL_BROADCAST);
    emitter->getChannel();
    emitter->setRange(-1);
    emitter->getRange();
    emitter->getBufferSize();
    if (emitter->send("text", 5) == 0)
      return;
  }

  Pen *pen = robot->getPen("pen");
  if (pen != NULL) {
    pen->write(true);
    pen->setInkColor(0xFF0000, 0.5);
  }

  Skin *skin = robot->getSkin("skin");
  if (skin != NULL && skin->getBoneCount() > 0) {
    skin->getBoneName(0);
    skin->setBoneOrientation(0, skin->getBoneOrientation(0, true), true);
    skin->setBonePosition(0, skin->getBonePosition(0, false), false);
  }

  VacuumGripper *gripper = robot->getVacuumGripper("gripper");
  if (gripper != NULL) {
    gripper->enablePresence(16);
    gripper->getPresenceSamplingPeriod();
    gripper->getPresence();
    gripper->turnOn();
    gripper->isOn();
    gripper->turnOff();
    gripper->disablePresence();
  }
}
