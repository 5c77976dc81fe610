// Writers of the three formats. Each writes the given fields only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gap/export/fields.hpp"
#include "gap/export/targets.hpp"

namespace darwinop::gap {

struct JointText {
  const ExportSettings& settings;
  ServoNumbers servo;
  ArmNumbers arm;
  std::vector<std::string> head, foot;  // comments

  /// Of the link about its own centre of mass; as small as formats allow where the arm is a point.
  [[nodiscard]] double ownInertia() const;
  /// With the servo's armature, for formats that have no place for it. The same about all axes: about one axis
  /// alone it would not be a possible body.
  [[nodiscard]] double inertiaWithArmature() const { return ownInertia() + servo.armature_kgm2; }
  [[nodiscard]] double mass() const;
};

std::string webotsText(const JointText& joint, const WebotsFields& fields);
/// Elements inside <actuator>.
std::string mujocoActuators(const JointText& joint, const MujocoFields& fields);
std::string mujocoText(const JointText& joint, const MujocoFields& fields);
std::string urdfText(const JointText& joint, const UrdfFields& fields);

/// The shortest text that gives the same number back.
std::string shortest(double value);
/// ` key="value"`.
std::string attribute(std::string_view key, double value);
/// One comment a line.
std::string xmlComments(const std::vector<std::string>& lines, std::string_view indent);

}  // namespace darwinop::gap
