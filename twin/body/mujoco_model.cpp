// Loads the MuJoCo body and applies the settings of the model file.
#include "twin/body/mujoco_model.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "hal/text_file.hpp"
#include "twin/body/ground.hpp"
#include "twin/body/link_inertia.hpp"
#include "twin/body/mujoco_guard.hpp"
#include "twin/body/trunk.hpp"

namespace darwinop::twin {
namespace {

constexpr double kFrictionSteps = 2;  // minimum time constant of a friction constraint in MuJoCo, steps

std::string readText(const std::string& path) {
  const std::optional<std::string> text = readTextFile(path);
  if (!text)
    throw std::runtime_error{"cannot read the body file " + path + "; check `xml` in section [body] of the model"};
  return *text;
}

// Edits the text, because this MuJoCo version cannot remove a body from a compiled model. Does nothing without a ball.
void removeBall(std::string& xml) {
  const auto erase = [&](std::string_view first, std::string_view last) {
    const auto from = xml.find(first);
    const auto to = xml.find(last, from);
    if (from == std::string::npos || to == std::string::npos) return false;
    xml.erase(from, to + last.size() - from);
    return true;
  };
  erase("<body name=\"ball\"", "</body>");
  erase("<pair geom1=\"floor\" geom2=\"ball\"", "/>");
  while (erase("<pair geom1=\"ball\"", "/>")) {
  }
}

MjModelPtr compile(const std::string& xml, const std::string& path) {
  constexpr const char* kName = "body.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(xml.size())) != 0)
    throw std::runtime_error{path + ": the body file is too large"};
  const int at = mj_findFileVFS(files.get(), kName);
  std::memcpy(files->filedata[at], xml.data(), xml.size());
  std::array<char, 1000> why{};
  mjModel* loaded = nullptr;
  orThrow(path, [&] { loaded = mj_loadXML(kName, files.get(), why.data(), static_cast<int>(why.size())); });
  MjModelPtr model{loaded};
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error{path + ": MuJoCo cannot load this body: " + oneLine(why.data())};
  return model;
}

// Contact parameters of the floor: of the listed pairs, and of the geom for dynamic collision detection.
void setFloor(mjModel& m, int floor, const BodySettings& settings) {
  m.geom_friction[3 * floor] = settings.floor_friction;
  m.geom_solref[mjNREF * floor] = settings.contact_time_s;
  for (int p = 0; p < m.npair; ++p) {
    if (m.pair_geom1[p] != floor && m.pair_geom2[p] != floor) continue;
    m.pair_friction[5 * p] = m.pair_friction[5 * p + 1] = settings.floor_friction;
    m.pair_solref[mjNREF * p] = settings.contact_time_s;
  }
}

void setLinks(mjModel& m, const BodyMap& map, const Model& model) {
  for (std::size_t link = 0; link < kLinks; ++link) {
    if (model.links[link] == LinkSettings{}) continue;
    const int body = link == kTrunkLink ? map.trunk : map.link[link];
    const double of_file_kg = m.body_mass[body];
    changeLink(m, body, model.links[link]);
    if (inertiaOfLink(m, body).isPossible()) continue;
    throw std::runtime_error{whereLinkIs(model, link) + " mass = " + std::to_string(model.links[link].mass_kg) +
                             " kg leaves no possible body; the file " + model.body.xml + " gives this link " +
                             std::to_string(of_file_kg) + " kg, take less away or closer to the centre of mass"};
  }
}

// Recomputes MuJoCo's constants that depend on masses.
void updateConstants(mjModel& m, const std::string& file) {
  const MjDataPtr data = dataFor(m, file);
  orThrow(file, [&] { mj_setConst(&m, data.get()); });
}

// Off: only the listed pairs. On: all geoms with matching masks, so the robot's geoms need a common bit.
void setSelfCollision(mjModel& m, int trunk, bool on) {
  m.opt.collision = on ? mjCOL_DYNAMIC : mjCOL_PAIR;
  for (int g = 0; g < m.ngeom; ++g)
    if (m.body_rootid[m.geom_bodyid[g]] == trunk && m.geom_contype[g] != 0) m.geom_conaffinity[g] = on ? 3 : 1;
}

}  // namespace

MjDataPtr dataFor(const mjModel& m, const std::string& file) {
  mjData* data = nullptr;
  orThrow(file, [&] { data = mj_makeData(&m); });
  if (data == nullptr) throw std::runtime_error{file + ": not enough memory for this body"};
  return MjDataPtr{data};
}

MjModelPtr loadBody(const Model& model, bool ball) {
  const BodySettings& settings = model.body;
  const std::string path = (std::filesystem::path{model.folder} / settings.xml).string();
  std::string xml = readText(path);
  if (xml.empty()) throw std::runtime_error{path + ": the body file is empty"};
  if (!ball) removeBall(xml);
  MjModelPtr compiled = compile(xml, path);
  mjModel& m = *compiled;
  const BodyMap map = mapBody(m, path);

  m.opt.timestep = settings.step_s;
  const double friction_time_s = kFrictionSteps * settings.step_s;
  for (std::size_t i = 0; i < kJoints; ++i) {
    m.dof_solref[map.dof[i] * mjNREF] = friction_time_s;
    m.tendon_solref_fri[map.motor[i] * mjNREF] = friction_time_s;
  }
  setFloor(m, map.floor, settings);
  setSelfCollision(m, map.trunk, settings.self_collision);
  setTrunk(m, map.trunk, settings);
  setLinks(m, map, model);
  if (settings.sole_size != 1) scaleSoles(m, map, settings.sole_size);
  if (settings.floor_tilt_x_rad != 0 || settings.floor_tilt_y_rad != 0)
    tiltFloor(m, settings.floor_tilt_x_rad, settings.floor_tilt_y_rad);
  if (m.opt.integrator == mjINT_RK4)
    throw std::runtime_error{path + ": integrator RK4 is not supported; use Euler, or remove the attribute"};
  updateConstants(m, path);
  return compiled;
}

BodyMap mapBody(const mjModel& m, const std::string& file) {
  const auto find = [&](mjtObj kind, const char* what, std::string_view name) {
    const int id = mj_name2id(&m, kind, std::string{name}.c_str());
    if (id < 0) throw std::runtime_error{file + ": the body has no " + what + " \"" + std::string{name} + '"'};
    return id;
  };
  BodyMap map;
  map.trunk = find(mjOBJ_BODY, "body", "Body");
  const int free = m.body_jntadr[map.trunk];
  if (free < 0 || m.jnt_type[free] != mjJNT_FREE)
    throw std::runtime_error{file + ": the body \"Body\" needs a <freejoint/>"};
  map.trunk_qpos = m.jnt_qposadr[free];
  map.trunk_dof = m.jnt_dofadr[free];
  map.joint_of_dof.assign(static_cast<std::size_t>(m.nv), -1);
  map.joint_of_motor.assign(static_cast<std::size_t>(m.ntendon), -1);
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::string_view name = kJointTable[i].name;
    const int joint = find(mjOBJ_JOINT, "joint", name);
    if (m.jnt_type[joint] != mjJNT_HINGE)
      throw std::runtime_error{file + ": joint \"" + std::string{name} + "\" is not a hinge"};
    map.qpos[i] = m.jnt_qposadr[joint];
    map.dof[i] = m.jnt_dofadr[joint];
    map.link[i] = m.jnt_bodyid[joint];
    map.motor[i] = find(mjOBJ_TENDON, "fixed tendon", name);
    map.joint_of_dof[static_cast<std::size_t>(map.dof[i])] = static_cast<int>(i);
    map.joint_of_motor[static_cast<std::size_t>(map.motor[i])] = static_cast<int>(i);
  }
  map.gyro = find(mjOBJ_SITE, "site", "gyro");
  map.accelerometer = find(mjOBJ_SITE, "site", "accelerometer");
  map.floor = find(mjOBJ_GEOM, "geom", "floor");
  const int ball = mj_name2id(&m, mjOBJ_JOINT, "ball");
  if (ball >= 0) {
    map.ball_qpos = m.jnt_qposadr[ball];
    map.ball_dof = m.jnt_dofadr[ball];
  }
  return map;
}

void applyLoads(mjModel& m, const BodyMap& map, const std::array<double, kJoints>& rotor_kgm2,
                const std::array<LoadChange, kJoints>& changes) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const LoadChange& change = changes[i];
    m.dof_armature[map.dof[i]] = rotor_kgm2[i];
    m.body_mass[map.link[i]] *= change.mass_scale;
    for (int k = 0; k < 3; ++k) m.body_inertia[3 * map.link[i] + k] *= change.mass_scale;

    // The joint anchor is the link's origin: the mass moves along the line from there, inward at most to the anchor.
    mjtNum* weight = m.body_ipos + 3 * map.link[i];
    const double distance = mju_norm3(weight);
    if (distance > 0) mju_scl3(weight, weight, std::max(0.0, distance + change.com_shift_m) / distance);

    // A hinge rotates its link by qpos - qpos0, so the encoder reads the true angle + offset. The mechanical stops stay
    // at the true angle.
    const int joint = m.dof_jntid[map.dof[i]];
    m.qpos0[map.qpos[i]] += change.angle_offset_rad;
    m.jnt_range[2 * joint] += change.angle_offset_rad;
    m.jnt_range[2 * joint + 1] += change.angle_offset_rad;
  }
  updateConstants(m, "the body");
}

}  // namespace darwinop::twin
