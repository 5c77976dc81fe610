// Node types that Device::getNodeType() returns. A robot has no scene tree.
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
