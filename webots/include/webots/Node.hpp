// Kinds of nodes, as Device::getNodeType() names them. There is no scene tree on a robot.
#ifndef NODE_HPP
#define NODE_HPP

namespace webots {

class Node {
 public:
  /// Compare by name: the simulator's numbers change between its versions.
  enum Type {
    NO_NODE,
    ROBOT,
    ACCELEROMETER,
    CAMERA,
    GYRO,
    LED,
    POSITION_SENSOR,
    ROTATIONAL_MOTOR,
    SPEAKER,
    TOUCH_SENSOR
  };

 private:
  Node();
};

}  // namespace webots

#endif
