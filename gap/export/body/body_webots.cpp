// Nodes of a PROTO and of its world, with the numbers of the model.
#include <algorithm>

#include "core/registers.hpp"
#include "gap/export/body/body_texts.hpp"
#include "twin/body/imu_axes.hpp"

namespace darwinop::gap {
namespace {

std::string physicsOf(const BodyText& of, std::size_t link) {
  const twin::LinkInertia is = of.link(link);
  const Eigen::Matrix3d& i = is.inertia_kgm2;
  std::string text = "# Solid " + std::string{twin::linkName(link)} + ", without the servo's armature\n";
  text += "Physics {\n  density -1\n  mass " + shortest(is.mass_kg) + "\n  centerOfMass [ " +
          threeNumbers(is.com_m.data()) + " ]\n  inertiaMatrix [ ";
  text += shortest(i(0, 0)) + " " + shortest(i(1, 1)) + " " + shortest(i(2, 2)) + ", " + shortest(i(0, 1)) + " " +
          shortest(i(0, 2)) + " " + shortest(i(1, 2)) + " ]\n}\n";
  return text;
}

std::string jointOf(std::string_view name, const WebotsFields& f, double armature) {
  return "# Joint " + std::string{name} + "; armature " + shortest(armature) + " kg m2\n" +
         "HingeJointParameters {\n  dampingConstant " + shortest(f.damping_constant) + "\n  staticFriction " +
         shortest(f.static_friction) + "\n}\nRotationalMotor {\n  name \"" + std::string{name} + "\"\n  maxVelocity " +
         shortest(f.max_velocity) + "\n  acceleration " + shortest(f.acceleration) + "\n  maxTorque " +
         shortest(f.max_torque) + "\n  controlPID " + shortest(f.p) + " " + shortest(f.i) + " " + shortest(f.d) +
         "\n}\n" + (f.gap > 0 ? "# HingeJointWithBacklash: gap " + shortest(f.gap) + "\n" : "");
}

/// Its register's counts, as controllers of the simulator expect them: 512 is zero; it saturates at the ends of the
/// register, or earlier at `range`.
std::string sensorOf(const char* node, const Register& counts, double range, const twin::MountingQuaternion& mounted) {
  mjtNum axis[3];
  mju_quat2Vel(axis, mounted.data(), 1);
  const mjtNum angle = mju_normalize3(axis);
  const double end = std::min(range, counts.zero * counts.scale), most = end / counts.scale;
  return std::string{node} + " {  # rotation: of the sensor's axes in the trunk; lookupTable: SI units to counts\n" +
         "  rotation " + threeNumbers(axis) + " " + shortest(angle) + "\n  lookupTable [ " + shortest(-end) + " " +
         shortest(counts.zero - most) + " 0, " + shortest(end) + " " + shortest(counts.zero + most) + " 0 ]\n}\n";
}

std::string worldOf(const BodyText& of) {
  const twin::BodySettings& body = of.model.body;
  std::string text =
      "# World: floor\nContactProperties {\n  coulombFriction [ " + shortest(body.floor_friction) + " ]\n}\n";
  const double x = body.floor_tilt_x_rad, y = body.floor_tilt_y_rad;
  if (x != 0 || y != 0)
    text += "# Turn the floor by " + shortest(x) + " rad about the world's x (forward), then by " + shortest(y) +
            " rad about y (left).\n";
  if (body.sole_size != 1)
    text += "# Multiply length and width of the boxes of FootR and FootL by " + shortest(body.sole_size) + ".\n";
  return text;
}

}  // namespace

std::string webotsBody(const BodyText& of, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& line : comments) text += "# " + line + "\n";
  for (std::size_t link = 0; link < twin::kLinks; ++link) text += physicsOf(of, link);
  for (std::size_t i = 0; i < kJoints; ++i)
    text += jointOf(kJointTable[i].name, webotsFields(of.servos[i]), of.servos[i].armature_kgm2);
  const twin::ImuSettings& imu = of.model.imu;
  constexpr const Register &kGyro = find(kCm730, "gyro_x"), &kAccel = find(kCm730, "accel_x");
  text += sensorOf("Gyro", kGyro, imu.gyro_range_rad_s, twin::mountedAt(of.body.site_quat + 4 * of.map.gyro, imu));
  text += sensorOf("Accelerometer", kAccel, imu.accel_range_m_s2,
                   twin::mountedAt(of.body.site_quat + 4 * of.map.accelerometer, imu));
  return text + worldOf(of);
}

}  // namespace darwinop::gap
