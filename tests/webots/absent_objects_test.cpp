// Objects that controllers make of classes that this robot has no device of, by a class of their own or by new.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <webots/Altimeter.hpp>
#include <webots/Brake.hpp>
#include <webots/Compass.hpp>
#include <webots/Connector.hpp>
#include <webots/Display.hpp>
#include <webots/DistanceSensor.hpp>
#include <webots/Emitter.hpp>
#include <webots/GPS.hpp>
#include <webots/InertialUnit.hpp>
#include <webots/Lidar.hpp>
#include <webots/LightSensor.hpp>
#include <webots/Node.hpp>
#include <webots/Pen.hpp>
#include <webots/Radar.hpp>
#include <webots/RangeFinder.hpp>
#include <webots/Receiver.hpp>
#include <webots/Skin.hpp>
#include <webots/VacuumGripper.hpp>

#include "fixture.hpp"
#include "webots/messages.hpp"

namespace darwinop::webots_api {
namespace {

using testing::Each;
using testing::IsNan;

/// Counts its objects.
class OwnGps : public webots::GPS {
 public:
  explicit OwnGps(const std::string& name) : GPS(name) { ++alive; }
  ~OwnGps() override { --alive; }
  static int alive;
};
int OwnGps::alive = 0;

/// Has a setter of its own.
class Beacon : public webots::Emitter {
 public:
  Beacon() : Emitter("beacon") {}
  int send(const void*, int size) override { return size; }
};

class RobotWithGps : public webots::Robot {
 public:
  explicit RobotWithGps(RobotImpl* impl) : Robot(impl) {}
  mutable int makes = 0;

 protected:
  webots::GPS* createGPS(const std::string& name) const override {
    ++makes;
    return new OwnGps{name};
  }
};

using AbsentObjects = Facade;

/// The line on stderr about an object.
std::string logLineOf(const std::string& object) {
  return "darwinop: " + object + messages::kAbsentDevice + "\n";
}

std::vector<double> vectorOf(const double* values, std::size_t size) {
  return {values, values + size};
}

TEST_F(AbsentObjects, EachClassReportsOncePerNameThatTheRobotHasNone) {
  robot();
#define ROW(CLASS)                                                                               \
  {                                                                                              \
    testing::internal::CaptureStderr();                                                          \
    const webots::CLASS first{"front"};                                                          \
    const webots::CLASS again{"front"};                                                          \
    const webots::CLASS other{"back"};                                                           \
    EXPECT_EQ(testing::internal::GetCapturedStderr(),                                            \
              logLineOf(#CLASS "(\"front\")") + logLineOf(#CLASS "(\"back\")"));                 \
    EXPECT_EQ(first.getName(), "front");                                                         \
    EXPECT_EQ(first.getTag(), 0) << #CLASS;                                                      \
    EXPECT_EQ(first.getNodeType(), webots::Node::NO_NODE) << #CLASS;                             \
    EXPECT_EQ(robot().getDevice("front"), nullptr) << #CLASS << " is not a device of the robot"; \
  }
  DARWINOP_ABSENT_DEVICES(ROW)
#undef ROW
}

TEST_F(AbsentObjects, WhatWouldBeMeasuredIsNaN) {
  robot();
  const webots::Compass compass{"c"};
  const webots::GPS gps{"g"};
  const webots::InertialUnit unit{"u"};
  const webots::Receiver receiver{"r"};
  const webots::Skin skin{"s"};
  EXPECT_THAT(vectorOf(compass.getValues(), 3), Each(IsNan()));
  EXPECT_THAT(vectorOf(gps.getValues(), 3), Each(IsNan()));
  EXPECT_THAT(vectorOf(gps.getSpeedVector(), 3), Each(IsNan()));
  EXPECT_THAT(vectorOf(unit.getRollPitchYaw(), 3), Each(IsNan()));
  EXPECT_THAT(vectorOf(unit.getQuaternion(), 4), Each(IsNan()));
  EXPECT_THAT(vectorOf(receiver.getEmitterDirection(), 3), Each(IsNan()));
  EXPECT_THAT(vectorOf(skin.getBoneOrientation(0, true), 4), Each(IsNan()));
  EXPECT_THAT(vectorOf(skin.getBonePosition(0, true), 3), Each(IsNan()));

  const webots::DistanceSensor distance{"d"};
  const webots::Emitter emitter{"e"};
  const webots::Lidar lidar{"l"};
  const webots::Radar radar{"r"};
  const webots::RangeFinder finder{"f"};
  const std::vector<double> numbers{webots::Altimeter{"a"}.getValue(),
                                    webots::LightSensor{"l"}.getValue(),
                                    gps.getSpeed(),
                                    unit.getNoise(),
                                    receiver.getSignalStrength(),
                                    emitter.getRange(),
                                    distance.getValue(),
                                    distance.getMinValue(),
                                    distance.getMaxValue(),
                                    distance.getAperture(),
                                    lidar.getMinFrequency(),
                                    lidar.getMaxFrequency(),
                                    lidar.getFrequency(),
                                    lidar.getFov(),
                                    lidar.getVerticalFov(),
                                    lidar.getMinRange(),
                                    lidar.getMaxRange(),
                                    radar.getMinRange(),
                                    radar.getMaxRange(),
                                    radar.getHorizontalFov(),
                                    radar.getVerticalFov(),
                                    finder.getFov(),
                                    finder.getMinRange(),
                                    finder.getMaxRange(),
                                    webots::RangeFinder::rangeImageGetDepth(nullptr, 0, 0, -1)};
  EXPECT_THAT(numbers, Each(IsNan()));
}

TEST_F(AbsentObjects, ListsAreEmptyAndNull) {
  robot();
  const webots::Compass compass{"c"};
  const webots::Display display{"d"};
  const webots::Lidar lidar{"l"};
  const webots::Radar radar{"r"};
  const webots::RangeFinder finder{"f"};
  const webots::Receiver receiver{"r"};
  EXPECT_EQ(compass.getLookupTableSize(), 0);
  EXPECT_EQ(compass.getLookupTable(), nullptr);
  EXPECT_EQ(lidar.getNumberOfPoints() + lidar.getHorizontalResolution() + lidar.getNumberOfLayers(), 0);
  EXPECT_EQ(lidar.getRangeImage(), nullptr);
  EXPECT_EQ(lidar.getPointCloud(), nullptr);
  EXPECT_EQ(radar.getNumberOfTargets(), 0);
  EXPECT_EQ(radar.getTargets(), nullptr);
  EXPECT_EQ(finder.getWidth() + finder.getHeight(), 0);
  EXPECT_EQ(finder.getRangeImage(), nullptr);
  EXPECT_EQ(finder.saveImage("depth.png", 100), -1);
  EXPECT_EQ(receiver.getQueueLength(), 0);
  EXPECT_EQ(receiver.getDataSize(), 0);
  EXPECT_EQ(receiver.getData(), nullptr);
  EXPECT_EQ(display.getWidth() + display.getHeight(), 0);
  EXPECT_EQ(display.imageNew(1, 1, "123", webots::Display::RGB), nullptr);
  EXPECT_EQ(webots::Skin{"s"}.getBoneCount(), 0);
  EXPECT_EQ(webots::Skin{"s"}.getBoneName(0), "");
}

TEST_F(AbsentObjects, NothingIsSentHeldOrConnected) {
  robot();
  webots::Connector connector{"c"};
  connector.lock();
  EXPECT_FALSE(connector.isLocked());
  EXPECT_EQ(connector.getPresence(), -1);
  webots::VacuumGripper gripper{"g"};
  gripper.turnOn();
  EXPECT_FALSE(gripper.isOn() || gripper.getPresence());
  EXPECT_EQ(webots::Emitter{"e"}.send("text", 5), 0);
  EXPECT_EQ(webots::Brake{"b"}.getMotor(), nullptr);
}

TEST_F(AbsentObjects, SamplingPeriodsAreThoseThatWereSet) {
  robot();
  webots::GPS gps{"g"};
  webots::Connector connector{"c"};
  webots::VacuumGripper gripper{"g"};
  EXPECT_EQ(gps.getSamplingPeriod() + connector.getPresenceSamplingPeriod() + gripper.getPresenceSamplingPeriod(), 0);
  gps.enable(16);
  connector.enablePresence(32);
  gripper.enablePresence(64);
  EXPECT_EQ(gps.getSamplingPeriod(), 16);
  EXPECT_EQ(connector.getPresenceSamplingPeriod(), 32);
  EXPECT_EQ(gripper.getPresenceSamplingPeriod(), 64);
  gps.disable();
  connector.disablePresence();
  gripper.disablePresence();
  EXPECT_EQ(gps.getSamplingPeriod() + connector.getPresenceSamplingPeriod() + gripper.getPresenceSamplingPeriod(), 0);
}

TEST_F(AbsentObjects, AGetterReturnsWhatTheMakerOfTheControllerReturnedOnce) {
  {
    const RobotWithGps robot{makeImpl()};
    testing::internal::CaptureStderr();
    webots::GPS* const gps = robot.getGPS("gps");
    EXPECT_NE(dynamic_cast<OwnGps*>(gps), nullptr);
    EXPECT_EQ(robot.getGPS("gps"), gps);
    EXPECT_EQ(robot.makes, 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), logLineOf("GPS(\"gps\")"));
    delete gps;
    EXPECT_EQ(OwnGps::alive, 0);
    EXPECT_NE(robot.getGPS("gps"), nullptr);
    EXPECT_EQ(robot.makes, 2) << "what the controller deleted is made again";
  }
  EXPECT_EQ(OwnGps::alive, 0) << "the robot deletes them";
}

TEST_F(AbsentObjects, ACallThroughTheBaseClassReachesTheControllersOwn) {
  robot();
  Beacon beacon;
  webots::Emitter& emitter = beacon;
  EXPECT_EQ(emitter.send("text", 5), 5);
}

TEST_F(AbsentObjects, AnObjectMayOutliveTheRobot) {
  robot();
  const auto gps = std::make_unique<webots::GPS>("gps");
  end();
  EXPECT_TRUE(std::isnan(gps->getSpeed()));
}

TEST_F(AbsentObjects, WithoutARobotTheProgramEnds) {
  EXPECT_EXIT(webots::GPS{"gps"}, testing::ExitedWithCode(EXIT_FAILURE), testing::HasSubstr(messages::kNoRobotYet));
}

}  // namespace
}  // namespace darwinop::webots_api
