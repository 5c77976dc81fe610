// A whole URDF of one joint and two links.
#include "core/units.hpp"
#include "gap/export/texts.hpp"

namespace darwinop::gap {

std::string urdfText(const JointText& joint, const UrdfFields& f) {
  const std::string name = joint.settings.joint;
  const double own = joint.inertiaWithArmature();
  std::string text = "<robot name=\"" + name + "\">\n" + xmlComments(joint.head, "  ");
  text += "  <link name=\"" + name + "_base\"/>\n";
  text += "  <link name=\"" + name + "_link\">\n";
  text += xmlComments({"The arm of the bench; put your link here, and add the servo's armature, " +
                       shortest(joint.servo.armature_kgm2) + " kg m2, to its inertia as here."},
                      "    ");
  text += "    <inertial>\n      <origin xyz=\"0 0 " + shortest(-joint.arm.com_m) + "\" rpy=\"0 0 0\"/>\n";
  text += "      <mass" + attribute("value", joint.mass()) + "/>\n      <inertia" + attribute("ixx", own) +
          attribute("iyy", own) + attribute("izz", own) +
          " ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n    </inertial>\n  </link>\n";
  text += "  <joint name=\"" + name + "\" type=\"revolute\">\n";
  text += "    <origin xyz=\"0 0 0\" rpy=\"0 " + shortest(-joint.arm.hangs_at_rad) + " 0\"/>\n";
  text += "    <parent link=\"" + name + "_base\"/>\n    <child link=\"" + name + "_link\"/>\n";
  text += "    <axis xyz=\"0 1 0\"/>\n";
  text += xmlComments({"N m s/rad and N m."}, "    ");
  text += "    <dynamics" + attribute("damping", f.damping) + attribute("friction", f.friction) + "/>\n";
  text += xmlComments(
      {"lower, upper: put your range here. effort: N m, of the standing motor. velocity: rad/s, without load."},
      "    ");
  text += "    <limit" + attribute("lower", -kPi) + attribute("upper", kPi) + attribute("effort", f.effort) +
          attribute("velocity", f.velocity) + "/>\n  </joint>\n";
  return text + xmlComments(joint.foot, "  ") + "</robot>\n";
}

}  // namespace darwinop::gap
