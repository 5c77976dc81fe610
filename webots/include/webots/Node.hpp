// Nodes of the simulator's scene tree. A robot has no scene tree: only the types are used, by Device::getNodeType().
#ifndef NODE_HPP
#define NODE_HPP

#ifndef WB_USING_CPP_API
#define WB_USING_CPP_API
#endif

#include <string>

namespace webots {

class Field;
class Proto;

/// One point of Node::getContactPoints().
struct ContactPoint {
  double point[3];  // m
  int node_id;
};

/// No object exists here: Supervisor's calls that return nodes return NULL.
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
    TOUCH_SENSOR,
    // Types that no device of this robot has.
    ALTIMETER,
    APPEARANCE,
    BACKGROUND,
    BALL_JOINT,
    BALL_JOINT_PARAMETERS,
    BILLBOARD,
    BOX,
    BRAKE,
    CAPSULE,
    CHARGER,
    COLOR,
    COMPASS,
    CONE,
    CONNECTOR,
    CONTACT_PROPERTIES,
    COORDINATE,
    CYLINDER,
    DAMPING,
    DIRECTIONAL_LIGHT,
    DISPLAY,
    DISTANCE_SENSOR,
    ELEVATION_GRID,
    EMITTER,
    FLUID,
    FOCUS,
    FOG,
    GPS,
    GROUP,
    HINGE_2_JOINT,
    HINGE_JOINT,
    HINGE_JOINT_PARAMETERS,
    IMAGE_TEXTURE,
    IMMERSION_PROPERTIES,
    INDEXED_FACE_SET,
    INDEXED_LINE_SET,
    INERTIAL_UNIT,
    JOINT_PARAMETERS,
    LENS,
    LENS_FLARE,
    LIDAR,
    LIGHT_SENSOR,
    LINEAR_MOTOR,
    MATERIAL,
    MESH,
    MICROPHONE,
    MUSCLE,
    NORMAL,
    PBR_APPEARANCE,
    PEN,
    PHYSICS,
    PLANE,
    POINT_LIGHT,
    POINT_SET,
    POSE,
    PROPELLER,
    RADAR,
    RADIO,
    RANGE_FINDER,
    RECEIVER,
    RECOGNITION,
    SHAPE,
    SKIN,
    SLIDER_JOINT,
    SLOT,
    SOLID,
    SOLID_REFERENCE,
    SPHERE,
    SPOT_LIGHT,
    TEXTURE_COORDINATE,
    TEXTURE_TRANSFORM,
    TRACK,
    TRACK_WHEEL,
    TRANSFORM,
    VACUUM_GRIPPER,
    VIEWPOINT,
    WORLD_INFO,
    ZOOM,
    // Earlier names.
    CAMERA_ZOOM = ZOOM,
    DIFFERENTIAL_WHEELS = ROBOT,
    SERVO = ROTATIONAL_MOTOR,
    SUPERVISOR = ROBOT
  };

  virtual ~Node() {}
  /// Removes the node from the world.
  virtual void remove() = 0;
  /// The node as text of a world file.
  virtual std::string exportString() const = 0;
  /// Number of the node in its world; no unit.
  virtual int getId() const = 0;
  /// Kind of node.
  virtual Type getType() const = 0;
  /// DEF name.
  virtual std::string getDef() const = 0;
  /// Name of the type or of the PROTO.
  virtual std::string getTypeName() const = 0;
  /// Name of the type that the PROTO is made of.
  virtual std::string getBaseTypeName() const = 0;
  /// The node that contains this one.
  virtual Node* getParentNode() const = 0;
  /// Whether it is made of a PROTO.
  virtual bool isProto() const = 0;
  /// The PROTO.
  virtual Proto* getProto() const = 0;

  /// Node of a PROTO's body by its DEF name.
  virtual Node* getFromProtoDef(const std::string& name) const = 0;

  /// Number of fields.
  virtual int getNumberOfFields() const = 0;
  /// Field by number, 0 to getNumberOfFields() - 1.
  virtual Field* getFieldByIndex(int index) const = 0;
  /// Field by name.
  virtual Field* getField(const std::string& name) const = 0;
  /// Number of fields of the base type.
  virtual int getNumberOfBaseNodeFields() const = 0;
  /// Field of the base type, 0 to getNumberOfBaseNodeFields() - 1.
  virtual Field* getBaseNodeFieldByIndex(int index) const = 0;
  /// Field of the base type by name.
  virtual Field* getBaseNodeField(const std::string& name) const = 0;
  /// Same as getNumberOfBaseNodeFields(), under an earlier name.
  virtual int getProtoNumberOfFields() const = 0;
  /// Same as getBaseNodeFieldByIndex(), under an earlier name.
  virtual Field* getProtoFieldByIndex(int index) const = 0;
  /// Same as getBaseNodeField(), under an earlier name.
  virtual Field* getProtoField(const std::string& name) const = 0;

  /// X, Y, Z in m.
  virtual const double* getPosition() const = 0;
  /// Rotation matrix, 3 x 3, row by row, -1 to 1.
  virtual const double* getOrientation() const = 0;
  /// Transformation matrix, 4 x 4, row by row; positions in m.
  virtual const double* getPose() const = 0;
  /// As getPose(), relative to another node; m.
  virtual const double* getPose(const Node* from) const = 0;
  /// Records getPose() every `sampling_period` ms.
  virtual void enablePoseTracking(int sampling_period, const Node* from = 0) = 0;
  /// Ends enablePoseTracking().
  virtual void disablePoseTracking(const Node* from = 0) = 0;
  /// X, Y, Z in m.
  virtual const double* getCenterOfMass() const = 0;
  /// Contacts of the node in m; `*size`: Number of points.
  virtual ContactPoint* getContactPoints(bool include_descendants, int* size) const = 0;
  /// Records contacts every `sampling_period` ms.
  virtual void enableContactPointsTracking(int sampling_period, bool include_descendants = false) = 0;
  /// Ends enableContactPointsTracking().
  virtual void disableContactPointsTracking(bool include_descendants = false) = 0;
  /// Number of contacts, under an earlier name.
  virtual int getNumberOfContactPoints(bool include_descendants = false) const = 0;
  /// Contact by number, in m, under an earlier name.
  virtual const double* getContactPoint(int index) const = 0;
  /// Node by number of a contact, under an earlier name; 0 or more, no unit.
  virtual Node* getContactPointNode(int index) const = 0;
  /// Whether the centre of mass is above the support polygon.
  virtual bool getStaticBalance() const = 0;
  /// Velocity in m/s and angular velocity in rad/s: six numbers.
  virtual const double* getVelocity() const = 0;
  /// As getVelocity(); m/s and rad/s.
  virtual void setVelocity(const double velocity[6]) = 0;
  /// Force in N at the centre of mass, for one step; no unit for `relative`.
  virtual void addForce(const double force[3], bool relative) = 0;
  /// Force in N at an offset in m.
  virtual void addForceWithOffset(const double force[3], const double offset[3], bool relative) = 0;
  /// Torque in N m.
  virtual void addTorque(const double torque[3], bool relative) = 0;
  /// Stops the node.
  virtual void resetPhysics() = 0;
  /// Sets a joint, in rad or m; axis 1 to 3.
  virtual void setJointPosition(double position, int index = 1) = 0;
  /// Restarts the controller of a robot.
  virtual void restartController() = 0;
  /// Shows the node in the window.
  virtual void moveViewpoint() const = 0;
  /// Shows or hides the node in pictures of `from`.
  virtual void setVisibility(Node* from, bool visible) = 0;
  /// Stores the state of the node under a name.
  virtual void saveState(const std::string& state_name) = 0;
  /// Restores a state of saveState().
  virtual void loadState(const std::string& state_name) = 0;
};

}  // namespace webots

#endif
