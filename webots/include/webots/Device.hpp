// Base class of all devices.
#ifndef DEVICE_HPP
#define DEVICE_HPP

#ifndef WB_USING_CPP_API
#define WB_USING_CPP_API
#endif

#include <string>

namespace darwinop {
namespace webots_api {
class RobotImpl;
}
}  // namespace darwinop

namespace webots {

/// Devices belong to the Robot: get them with Robot::getMotor() and its siblings, never delete them. Threads: see
/// Robot. Sampling periods are stored for the getters; a robot reads all sensors in every cycle, except camera and
/// keyboard.
///
/// An object that a controller makes (`new LED("EyeLed")`, style of 2013) drives the same device; delete it before the
/// Robot, unless Robot::createLED() or a sibling returned it. Without a Robot, or if the robot has no such device, the
/// constructor logs the reason and ends the program with exit status 1. Of the classes in absent_devices.hpp the robot
/// has no device at all: their constructors log that once per name, and the program continues; getTag() is 0.
class Device {
 public:
  virtual ~Device();
  /// The name by which Robot finds the device.
  const std::string& getName() const { return name_; }
  /// Empty. Simulator: the model field of the node.
  std::string getModel() const;
  /// A Node::Type as a number; compare by name. NO_NODE: the robot has no such device.
  int getNodeType() const { return node_type_; }
  /// Same as getNodeType(), under an earlier name; no unit. Some devices have another getType().
  int getType() const { return node_type_; }
  /// Number of this device on its robot, from 1; 0: the robot has no such device. Fixed for a version of this library
  /// only.
  int getTag() const { return tag_; }

 protected:
  Device(const std::string& name, int node_type, darwinop::webots_api::RobotImpl& robot);
  /// An object of a class in absent_devices.hpp; `type` is the name of the class.
  Device(const std::string& name, const char* type);
  /// A second object for a device of the robot.
  explicit Device(const Device* of_the_robot);
  darwinop::webots_api::RobotImpl& robot_;

 private:
  friend class darwinop::webots_api::RobotImpl;
  virtual void refresh();  // called after each step; does nothing in devices that have nothing to prepare
  Device(const Device&);
  Device& operator=(const Device&);
  std::string name_;
  int node_type_, tag_;
};

}  // namespace webots

#endif
