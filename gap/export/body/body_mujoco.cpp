// The body's MuJoCo file with the numbers of the model, actuators of the servos and sensors of the board.
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "gap/export/body/body_texts.hpp"
#include "hal/text_file.hpp"
#include "twin/body/imu_axes.hpp"
#include "twin/body/mujoco_guard.hpp"

namespace darwinop::gap {
namespace {

/// What MuJoCo writes of the file that it loaded last, with the numbers of `m`. It writes to files only.
std::string savedXml(mjModel& m) {
  std::string path = (std::filesystem::temp_directory_path() / "darwinop-body-XXXXXX").string();
  const int file = mkstemp(path.data());
  if (file < 0) throw std::runtime_error(path + ": cannot be created, and MuJoCo writes its model to a file");
  close(file);
  std::array<char, 1000> why{};
  int is_saved = 0;
  twin::orThrow(path, [&] { is_saved = mj_saveLastXML(path.c_str(), &m, why.data(), static_cast<int>(why.size())); });
  const std::optional<std::string> text = readTextFile(path);
  std::filesystem::remove(path);
  if (is_saved == 0 || !text) throw std::runtime_error(path + ": MuJoCo cannot write the body: " + why.data());
  return *text;
}

std::string sensorsOf(const twin::ImuSettings& imu) {
  return "  <sensor>\n    <gyro name=\"Gyro\" site=\"gyro\"" + attribute("cutoff", imu.gyro_range_rad_s) +
         attribute("noise", imu.gyro_noise_rad_s) +
         "/>\n    <accelerometer name=\"Accelerometer\" site=\"accelerometer\"" +
         attribute("cutoff", imu.accel_range_m_s2) + attribute("noise", imu.accel_noise_m_s2) + "/>\n  </sensor>\n";
}

}  // namespace

std::string mujocoBody(const BodyText& of, const std::vector<std::string>& comments) {
  mjModel& m = of.body;
  std::string actuators;
  ExportSettings named = of.settings;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const int dof = of.map.dof[i];
    const MujocoFields fields = mujocoFields(of.servos[i], 1 / m.dof_invweight0[dof], m.opt.timestep);
    m.dof_armature[dof] = fields.armature, m.dof_damping[dof] = fields.damping;
    m.dof_frictionloss[dof] = fields.frictionloss;
    named.joint = std::string{kJointTable[i].name};
    actuators += mujocoActuators({.settings = named, .servo = of.servos[i], .arm = {}, .head = {}, .foot = {}}, fields);
  }
  for (const int site : {of.map.gyro, of.map.accelerometer}) {
    const twin::MountingQuaternion mounted = twin::mountedAt(m.site_quat + 4 * site, of.model.imu);
    std::ranges::copy(mounted, m.site_quat + 4 * site);
  }
  if (of.model.imu.gyro_noise_rad_s > 0 || of.model.imu.accel_noise_m_s2 > 0) m.opt.enableflags |= mjENBL_SENSORNOISE;
  std::string text = savedXml(m);
  const std::string added = "  <actuator>\n" + actuators + "  </actuator>\n" + sensorsOf(of.model.imu);
  text.insert(text.rfind("</mujoco>"), added);
  text.insert(text.find('\n', text.find("<mujoco")) + 1, xmlComments(comments, "  "));
  return text;
}

}  // namespace darwinop::gap
