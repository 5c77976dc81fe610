// What all devices of a robot have in common: a name.
#ifndef DEVICE_HPP
#define DEVICE_HPP

#ifndef WB_USING_CPP_API
#define WB_USING_CPP_API
#endif

#include <string>

namespace darwinop {
namespace facade {
class RobotImpl;
}
}  // namespace darwinop

namespace webots {

/// Devices belong to the Robot: get them with Robot::getMotor() and its siblings, never delete them.
class Device {
 public:
  virtual ~Device();
  const std::string& getName() const { return name_; }
  /// Empty: the robot does not tell.
  std::string getModel() const;
  /// One of Node::Type.
  int getNodeType() const { return node_type_; }
  /// Number of this device on its robot, from 1.
  int getTag() const { return tag_; }

 protected:
  Device(const std::string& name, int node_type, darwinop::facade::RobotImpl& robot);
  darwinop::facade::RobotImpl& robot_;

 private:
  friend class darwinop::facade::RobotImpl;
  Device(const Device&);
  Device& operator=(const Device&);
  std::string name_;
  int node_type_, tag_;
};

}  // namespace webots

#endif
