// Field of a node in the simulator's scene tree. A robot has no scene tree.
#ifndef FIELD_HPP
#define FIELD_HPP

#include <string>

namespace webots {

class Node;

/// No object exists here: Node::getField() returns one in simulation only. SF: one value; MF: a list, whose `index` is
/// 0 to getCount() - 1, or counts from the end: -1 is the last.
class Field {
 public:
  /// Kind of value; a list has the bit MF.
  enum Type {
    NO_FIELD = 0,
    SF_BOOL = 1,
    SF_INT32 = 2,
    SF_FLOAT = 3,
    SF_VEC2F = 4,
    SF_VEC3F = 5,
    SF_ROTATION = 6,
    SF_COLOR = 7,
    SF_STRING = 8,
    SF_NODE = 9,
    MF = 16,
    MF_BOOL = 17,
    MF_INT32 = 18,
    MF_FLOAT = 19,
    MF_VEC2F = 20,
    MF_VEC3F = 21,
    MF_ROTATION = 22,
    MF_COLOR = 23,
    MF_STRING = 24,
    MF_NODE = 25
  };

  virtual ~Field() {}
  /// Name of the field.
  virtual std::string getName() const = 0;
  /// Kind of value.
  virtual Type getType() const = 0;
  /// Kind of value as text, as "SFVec3f".
  virtual std::string getTypeName() const = 0;
  /// Number of values of a list.
  virtual int getCount() const = 0;
  /// The field itself, for a parameter of a PROTO.
  virtual Field* getActualField() const = 0;
  /// Records the value every `sampling_period` ms.
  virtual void enableSFTracking(int sampling_period) = 0;
  /// Ends enableSFTracking().
  virtual void disableSFTracking() = 0;

  // One value: read, set.

  /// Value; no unit.
  virtual bool getSFBool() const = 0;
  /// As getSFBool().
  virtual void setSFBool(bool value) = 0;
  /// Value; no unit.
  virtual int getSFInt32() const = 0;
  /// As getSFInt32().
  virtual void setSFInt32(int value) = 0;
  /// Value; no unit of its own.
  virtual double getSFFloat() const = 0;
  /// As getSFFloat().
  virtual void setSFFloat(double value) = 0;
  /// Two numbers; no unit of their own.
  virtual const double* getSFVec2f() const = 0;
  /// As getSFVec2f().
  virtual void setSFVec2f(const double value[2]) = 0;
  /// Three numbers; no unit of their own.
  virtual const double* getSFVec3f() const = 0;
  /// As getSFVec3f().
  virtual void setSFVec3f(const double value[3]) = 0;
  /// Axis and angle in rad.
  virtual const double* getSFRotation() const = 0;
  /// As getSFRotation().
  virtual void setSFRotation(const double value[4]) = 0;
  /// Red, green, blue, 0 to 1.
  virtual const double* getSFColor() const = 0;
  /// As getSFColor().
  virtual void setSFColor(const double value[3]) = 0;
  /// Text.
  virtual std::string getSFString() const = 0;
  /// As getSFString().
  virtual void setSFString(const std::string& value) = 0;
  /// The node; NULL: none.
  virtual Node* getSFNode() const = 0;

  // A list: read, set and insert one value.

  /// Value; no unit.
  virtual bool getMFBool(int index) const = 0;
  /// As getMFBool().
  virtual void setMFBool(int index, bool value) = 0;
  /// As getMFBool().
  virtual void insertMFBool(int index, bool value) = 0;
  /// Value; no unit.
  virtual int getMFInt32(int index) const = 0;
  /// As getMFInt32().
  virtual void setMFInt32(int index, int value) = 0;
  /// As getMFInt32().
  virtual void insertMFInt32(int index, int value) = 0;
  /// Value; no unit of its own.
  virtual double getMFFloat(int index) const = 0;
  /// As getMFFloat().
  virtual void setMFFloat(int index, double value) = 0;
  /// As getMFFloat().
  virtual void insertMFFloat(int index, double value) = 0;
  /// Two numbers; no unit of their own.
  virtual const double* getMFVec2f(int index) const = 0;
  /// As getMFVec2f().
  virtual void setMFVec2f(int index, const double value[2]) = 0;
  /// As getMFVec2f().
  virtual void insertMFVec2f(int index, const double value[2]) = 0;
  /// Three numbers; no unit of their own.
  virtual const double* getMFVec3f(int index) const = 0;
  /// As getMFVec3f().
  virtual void setMFVec3f(int index, const double value[3]) = 0;
  /// As getMFVec3f().
  virtual void insertMFVec3f(int index, const double value[3]) = 0;
  /// Axis and angle in rad.
  virtual const double* getMFRotation(int index) const = 0;
  /// As getMFRotation().
  virtual void setMFRotation(int index, const double value[4]) = 0;
  /// As getMFRotation().
  virtual void insertMFRotation(int index, const double value[4]) = 0;
  /// Red, green, blue, 0 to 1.
  virtual const double* getMFColor(int index) const = 0;
  /// As getMFColor().
  virtual void setMFColor(int index, const double value[3]) = 0;
  /// As getMFColor().
  virtual void insertMFColor(int index, const double value[3]) = 0;
  /// Text; `index` has no unit.
  virtual std::string getMFString(int index) const = 0;
  /// As getMFString().
  virtual void setMFString(int index, const std::string& value) = 0;
  /// As getMFString().
  virtual void insertMFString(int index, const std::string& value) = 0;
  /// Node by number; as getCount().
  virtual Node* getMFNode(int index) const = 0;

  /// Removes a value of a list; as getCount().
  virtual void removeMF(int index) = 0;
  /// Removes the node.
  virtual void removeSF() = 0;
  /// Inserts a node from a file; as getCount().
  virtual void importMFNode(int position, const std::string& filename) = 0;
  /// Inserts a node from text; as getCount().
  virtual void importMFNodeFromString(int position, const std::string& node_string) = 0;
  /// Sets a node from a file.
  virtual void importSFNode(const std::string& filename) = 0;
  /// Sets a node from text.
  virtual void importSFNodeFromString(const std::string& node_string) = 0;
};

}  // namespace webots

#endif
