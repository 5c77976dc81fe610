// A HingeJoint node, for the body of a PROTO.
#include "gap/export/texts.hpp"

namespace darwinop::gap {
namespace {

/// "      maxTorque 2.5  # N m, of the standing motor"
std::string field(std::string_view indent, std::string_view key, double value, std::string_view comment) {
  return std::string{indent} + std::string{key} + " " + shortest(value) + "  # " + std::string{comment} + "\n";
}

std::string comments(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "# " + line + "\n";
  return text;
}

std::string motor(const JointText& joint, const WebotsFields& f) {
  const bool pushes = joint.servo.p_on_torque;
  std::string text = "    RotationalMotor {\n      name \"" + joint.settings.joint + "\"\n";
  text += field("      ", "maxVelocity", f.max_velocity,
                pushes ? "rad/s, without load: supply against back EMF and friction, or a limit below it" : "rad/s");
  text += field("      ", "acceleration", f.acceleration, "rad/s2; -1: no limit");
  text += field("      ", "maxTorque", f.max_torque, pushes ? "N m, at rest: kt V duty_max / R" : "N m");
  text += "      controlPID " + shortest(f.p) + " " + shortest(f.i) + " " + shortest(f.d) +
          (pushes ? "  # 1/s, 1/s2, 1; P: the speed that the error's duty gives without load, not register / 8\n"
                  : "  # 1/s, 1/s2, 1; P: speed per error\n");
  return text + "    }\n";
}

std::string link(const JointText& joint) {
  const std::string own = shortest(joint.inertiaWithArmature());
  return "  endPoint Solid {  # the arm of the bench; put your link here\n"
         "    rotation 0 1 0 " +
         shortest(-joint.arm.hangs_at_rad) +
         "  # rad, zero of the encoder\n"
         "    physics Physics {\n"
         "      density -1\n"
         "      mass " +
         shortest(joint.mass()) +
         "  # kg\n"
         "      centerOfMass [ 0 0 " +
         shortest(-joint.arm.com_m) +
         " ]  # m\n"
         "      inertiaMatrix [ " +
         own + " " + own + " " + own + ", 0 0 0 ]  # kg m2, with the servo's armature: add " +
         shortest(joint.servo.armature_kgm2) +
         " to your link's, too\n"
         "    }\n"
         "  }\n";
}

}  // namespace

std::string webotsText(const JointText& joint, const WebotsFields& f) {
  std::string text = comments(joint.head);
  text += f.gap > 0 ? "HingeJointWithBacklash {\n" : "HingeJoint {\n";
  if (f.gap > 0) text += field("  ", "gap", f.gap, "rad, from one flank to the other");
  text += "  jointParameters HingeJointParameters {\n    axis 0 1 0\n";
  text += field("    ", "dampingConstant", f.damping_constant, "N m s/rad");
  text += field("    ", "staticFriction", f.static_friction, "N m");
  text += std::string{"  }\n  "} + (f.gap > 0 ? "devices" : "device") + " [\n" + motor(joint, f);
  text += "    PositionSensor {\n      name \"" + joint.settings.joint + "S\"\n";
  text += field("      ", "resolution", f.resolution, "rad, one step of the encoder");
  text += "    }\n  ]\n" + link(joint) + "}\n";
  return text + comments(joint.foot);
}

}  // namespace darwinop::gap
