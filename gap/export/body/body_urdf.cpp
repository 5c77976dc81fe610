// Inertias of links, and dynamics and limits of joints, for a URDF of the robot.
#include <Eigen/Geometry>

#include "gap/export/body/body_texts.hpp"

namespace darwinop::gap {
namespace {

/// Roll, pitch, yaw: about the fixed x, then y, then z.
Eigen::Vector3d rpyOf(const std::array<double, 4>& quat) {
  const Eigen::Vector3d turned =
      Eigen::Quaterniond{quat[0], quat[1], quat[2], quat[3]}.toRotationMatrix().eulerAngles(2, 1, 0);
  return {turned.z(), turned.y(), turned.x()};
}

}  // namespace

std::string urdfBody(const BodyText& of, const std::vector<std::string>& comments) {
  std::string text = "<robot name=\"" + of.model.name + "\">\n" + xmlComments(comments, "  ");
  for (std::size_t link = 0; link < twin::kLinks; ++link) {
    const twin::LinkInertia is = of.link(link);
    const Eigen::Matrix3d& i = is.inertia_kgm2;
    text += "  <link name=\"" + std::string{twin::linkName(link)} + "\">\n    <inertial>\n      <origin xyz=\"" +
            threeNumbers(is.com_m.data()) + "\" rpy=\"0 0 0\"/>\n      <mass" + attribute("value", is.mass_kg) +
            "/>\n      <inertia" + attribute("ixx", i(0, 0)) + attribute("iyy", i(1, 1)) + attribute("izz", i(2, 2)) +
            attribute("ixy", i(0, 1)) + attribute("ixz", i(0, 2)) + attribute("iyz", i(1, 2)) +
            "/>\n    </inertial>\n  </link>\n";
  }
  const mjModel& m = of.body;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const UrdfFields fields = urdfFields(of.servos[i]);
    const int joint = m.dof_jntid[of.map.dof[i]], parent = m.body_parentid[of.map.link[i]];
    const int body = of.map.link[i];
    text += xmlComments({"armature: " + shortest(of.servos[i].armature_kgm2) + " kg m2"}, "  ");
    text += "  <joint name=\"" + std::string{kJointTable[i].name} + "\" type=\"revolute\">\n    <origin xyz=\"" +
            threeNumbers(m.body_pos + 3 * body) + "\" rpy=\"" + threeNumbers(rpyOf(of.atZero(i)).data()) +
            "\"/>\n    <parent link=\"" + mj_id2name(&m, mjOBJ_BODY, parent) + "\"/>\n    <child link=\"" +
            std::string{twin::linkName(i)} + "\"/>\n    <axis xyz=\"" + threeNumbers(m.jnt_axis + 3 * joint) +
            "\"/>\n    <dynamics" + attribute("damping", fields.damping) + attribute("friction", fields.friction) +
            "/>\n    <limit" + attribute("lower", m.jnt_range[2 * joint]) +
            attribute("upper", m.jnt_range[2 * joint + 1]) + attribute("effort", fields.effort) +
            attribute("velocity", fields.velocity) + "/>\n  </joint>\n";
  }
  return text + "</robot>\n";
}

}  // namespace darwinop::gap
