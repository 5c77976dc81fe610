// PROTO of a node in the simulator's scene tree. A robot has no scene tree.
#ifndef PROTO_HPP
#define PROTO_HPP

#include <string>

namespace webots {

class Field;

/// No object exists here: Node::getProto() returns one in simulation only.
class Proto {
 public:
  virtual ~Proto() {}
  /// Name of the PROTO.
  virtual std::string getTypeName() const = 0;
  /// Whether it is made of another PROTO.
  virtual bool isDerived() const = 0;
  /// The other PROTO.
  virtual Proto* getProtoParent() const = 0;
  /// Number of parameters.
  virtual int getNumberOfFields() const = 0;
  /// Parameter by number, from 0; as getNumberOfFields().
  virtual Field* getFieldByIndex(int index) const = 0;
  /// Parameter by name.
  virtual Field* getField(const std::string& name) const = 0;
};

}  // namespace webots

#endif
