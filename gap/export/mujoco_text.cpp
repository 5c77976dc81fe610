// A whole MJCF file of one joint, so that it can be looked at; its lines fit into another model.
#include "gap/export/texts.hpp"

namespace darwinop::gap {
namespace {

std::string tag(std::string_view indent, std::string_view inside) {
  return std::string{indent} + "<" + std::string{inside} + "/>\n";
}

std::string hard(std::string_view what, double time_s, double impedance) {
  const std::string firm = shortest(impedance);
  return " solref" + std::string{what} + "=\"" + shortest(time_s) + " 1\" solimp" + std::string{what} + "=\"" + firm +
         " " + firm + " 0.001\"";
}

std::string joints(const JointText& joint, const MujocoFields& f) {
  const std::string name = joint.settings.joint;
  std::string text =
      tag("      ", "joint name=\"" + name + "\" type=\"hinge\" axis=\"0 1 0\"" + attribute("armature", f.armature) +
                        attribute("damping", f.damping) + attribute("frictionloss", f.frictionloss) +
                        hard("friction", f.hardTime(), kFrictionImpedance));
  if (f.play > 0) {
    text += xmlComments({"Play: the link turns freely within it. Angle of the link: the sum of both."}, "      ");
    text += tag("      ", "joint name=\"" + name + "_play\" type=\"hinge\" axis=\"0 1 0\" limited=\"true\" range=\"" +
                              shortest(-f.play / 2) + " " + shortest(f.play / 2) + "\"" +
                              hard("limit", f.hardTime(), kStopImpedance));
  } else if (f.stiffness > 0) {
    text += xmlComments({"Spring between horn and link; the encoder sits before it."}, "      ");
    text += tag("      ", "joint name=\"" + name + "_flex\" type=\"hinge\" axis=\"0 1 0\"" +
                              attribute("stiffness", f.stiffness) + attribute("damping", f.flex_damping));
  }
  return text;
}

std::string body(const JointText& joint, const MujocoFields& f) {
  const std::string own = shortest(joint.ownInertia());
  return "    <body name=\"" + joint.settings.joint + "_link\" axisangle=\"0 1 0 " + shortest(-joint.arm.hangs_at_rad) +
         "\">\n" +
         xmlComments({"The arm of the bench; put your link here. Turned by the zero of the encoder."}, "      ") +
         tag("      ", "inertial pos=\"0 0 " + shortest(-joint.arm.com_m) + "\"" + attribute("mass", joint.mass()) +
                           " diaginertia=\"" + own + " " + own + " " + own + "\"") +
         joints(joint, f) + "    </body>\n";
}

}  // namespace

std::string mujocoActuators(const JointText& joint, const MujocoFields& f) {
  const std::string name = joint.settings.joint, limit = shortest(f.force);
  std::string text = xmlComments(
      {joint.servo.p_on_torque
           ? "Controller: ctrl is the goal in rad. kp = kt V / R * duty per rad of error; forcerange: kt V duty_max / "
             "R."
           : "Motor that P gives a speed: ctrl is the goal in rad, kp = P kd, kd as firm as the time step allows."},
      "    ");
  text += tag("    ", "general name=\"" + name + "\" joint=\"" + name + "\" gaintype=\"fixed\" gainprm=\"" +
                          shortest(f.gain) + "\" biastype=\"affine\" biasprm=\"0 " + shortest(-f.kp) + " " +
                          shortest(-f.kd) + "\" forcelimited=\"true\" forcerange=\"-" + limit + " " + limit + "\"");
  if (f.back_emf > 0) {
    text += xmlComments(
        {"Back EMF, kt ke / R: brakes while the torque is on, beyond any forcerange. Its ctrl does nothing."}, "    ");
    text += tag("    ", "general name=\"" + name + "_back_emf\" joint=\"" + name +
                            "\" gaintype=\"fixed\" gainprm=\"0\" biastype=\"affine\" biasprm=\"0 0 " +
                            shortest(-f.back_emf) + "\"");
  }
  return text;
}

std::string mujocoText(const JointText& joint, const MujocoFields& f) {
  std::string text = "<mujoco model=\"" + joint.settings.joint + "\">\n" + xmlComments(joint.head, "  ");
  text += xmlComments({"Torque off: set gainprm and biasprm of its actuators to 0, and back again."}, "  ");
  text += "  <compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n";
  const std::string flag = f.sensor_noise > 0 ? "><flag sensornoise=\"enable\"/></option>\n" : "/>\n";  // default: none
  text += "  <option" + attribute("timestep", f.timestep) + " integrator=\"Euler\" gravity=\"0 0 " +
          shortest(-joint.arm.gravity_m_s2) + "\"" + flag;
  text += "  <worldbody>\n" + body(joint, f) + "  </worldbody>\n";
  text += "  <actuator>\n" + mujocoActuators(joint, f) + "  </actuator>\n";
  text += "  <sensor>\n" +
          tag("    ", "jointpos name=\"" + joint.settings.joint + "S\" joint=\"" + joint.settings.joint + "\"" +
                          attribute("noise", f.sensor_noise)) +
          "  </sensor>\n";
  return text + xmlComments(joint.foot, "  ") + "</mujoco>\n";
}

}  // namespace darwinop::gap
