// Nodes of a PROTO and of its world, with the numbers of the model.
#include <algorithm>
#include <array>
#include <cmath>

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

/// "rotation 0 1 0 0.1"
std::string rotation(const std::array<double, 4>& quat) {
  mjtNum axis[3];
  mju_quat2Vel(axis, quat.data(), 1);
  const mjtNum angle = mju_normalize3(axis);
  return "rotation " + threeNumbers(axis) + " " + shortest(angle);
}

std::string jointOf(const BodyText& of, std::size_t joint) {
  const WebotsFields f = webotsFields(of.servos[joint]);
  const std::string name{kJointTable[joint].name};
  return "# Joint " + name + "; armature " + shortest(of.servos[joint].armature_kgm2) + " kg m2\n" +
         (f.gap > 0 ? "HingeJointWithBacklash {\n  gap " + shortest(f.gap) + "\n}\n" : "") +
         "HingeJointParameters {\n  dampingConstant " + shortest(f.damping_constant) + "\n  staticFriction " +
         shortest(f.static_friction) + "\n}\nRotationalMotor {\n  name \"" + name + "\"\n  maxVelocity " +
         shortest(f.max_velocity) + "\n  acceleration " + shortest(f.acceleration) + "\n  maxTorque " +
         shortest(f.max_torque) + "\n  controlPID " + shortest(f.p) + " " + shortest(f.i) + " " + shortest(f.d) +
         "\n}\nSolid {  # endPoint, at position 0\n  " + rotation(of.atZero(joint)) + "\n}\n";
}

/// Its register's counts, as controllers of the simulator expect them: 512 is zero; it saturates at the ends of the
/// register, or earlier at `range`.
std::string sensorOf(const char* node, const Register& counts, double range, const twin::MountingQuaternion& mounted) {
  const double end = std::min(range, counts.zero * counts.scale), most = end / counts.scale;
  return std::string{node} + " {  # rotation: of the sensor's axes in the trunk; lookupTable: SI units to counts\n  " +
         rotation(mounted) + "\n  lookupTable [ " + shortest(-end) + " " + shortest(counts.zero - most) + " 0, " +
         shortest(end) + " " + shortest(counts.zero + most) + " 0 ]\n}\n";
}

std::string soleOf(const BodyText& of, Joint foot) {
  const mjModel& m = of.body;
  std::string text;
  for (int g = 0; g < m.ngeom; ++g) {
    if (m.geom_bodyid[g] != of.map.link[index(foot)] || m.geom_contype[g] == 0 || m.geom_type[g] != mjGEOM_BOX)
      continue;
    mjtNum size[3];
    mju_scl3(size, m.geom_size + 3 * g, 2);  // MuJoCo has halves
    text += "Box {  # boundingObject of " + std::string{row(foot).name} + "\n  size " + threeNumbers(size) + "\n}\n";
  }
  return text;
}

std::string worldOf(const BodyText& of) {
  const twin::BodySettings& body = of.model.body;
  constexpr double kMs = 1e-3;
  constexpr mjtNum kX[3] = {1, 0, 0}, kY[3] = {0, 1, 0};
  std::array<double, 4> about_x{}, about_y{}, tilt{};
  mju_axisAngle2Quat(about_x.data(), kX, body.floor_tilt_x_rad);
  mju_axisAngle2Quat(about_y.data(), kY, body.floor_tilt_y_rad);
  mju_mulQuat(tilt.data(), about_y.data(), about_x.data());
  return soleOf(of, Joint::kFootR) + soleOf(of, Joint::kFootL) + "Robot {\n  selfCollision " +
         (body.self_collision ? "TRUE" : "FALSE") +
         "\n}\n# World: x forward, y left, z up\nWorldInfo {\n  basicTimeStep " +
         shortest(std::max(1.0, std::round(body.step_s / kMs))) + "\n}\nContactProperties {\n  coulombFriction [ " +
         shortest(body.floor_friction) + " ]\n}\nFloor {\n  " + rotation(tilt) + "\n}\n";
}

}  // namespace

std::string webotsBody(const BodyText& of, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& line : comments) text += "# " + line + "\n";
  for (std::size_t link = 0; link < twin::kLinks; ++link) text += physicsOf(of, link);
  for (std::size_t i = 0; i < kJoints; ++i) text += jointOf(of, i);
  const twin::ImuSettings& imu = of.model.imu;
  constexpr const Register &kGyro = find(kCm730, "gyro_x"), &kAccel = find(kCm730, "accel_x");
  text += sensorOf("Gyro", kGyro, imu.gyro_range_rad_s, twin::mountedAt(of.body.site_quat + 4 * of.map.gyro, imu));
  text += sensorOf("Accelerometer", kAccel, imu.accel_range_m_s2,
                   twin::mountedAt(of.body.site_quat + 4 * of.map.accelerometer, imu));
  return text + worldOf(of);
}

}  // namespace darwinop::gap
