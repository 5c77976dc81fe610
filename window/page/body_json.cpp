// Writes the compiled MuJoCo body as JSON.
#include "window/page/body_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/joints.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/model/model.hpp"

namespace darwinop::window {
namespace {

using nlohmann::json;

constexpr int kDrawnGroup = 1;  // class "visual" of the body file; collision shapes are group 3
constexpr double kDigits = 1e7;

// 0.1 micrometre is finer than any rendering and halves the length of the text.
double rounded(double value) {
  return std::round(value * kDigits) / kDigits + 0.0;  // + 0.0: no -0
}

json list(const mjtNum* values, int count) {
  json out = json::array();
  for (int i = 0; i < count; ++i) out.push_back(rounded(values[i]));
  return out;
}

const char* shapeName(int type) {
  switch (type) {
    case mjGEOM_SPHERE:
      return "sphere";
    case mjGEOM_CAPSULE:
      return "capsule";
    case mjGEOM_ELLIPSOID:
      return "ellipsoid";
    case mjGEOM_CYLINDER:
      return "cylinder";
    case mjGEOM_BOX:
      return "box";
    default:
      return nullptr;  // other types are not drawn
  }
}

json colourOf(const mjModel& m, int geom) {
  const int material = m.geom_matid[geom];
  const float* rgba = material < 0 ? m.geom_rgba + 4 * geom : m.mat_rgba + 4 * material;
  json out = json::array();
  for (int i = 0; i < 3; ++i) out.push_back(std::round(static_cast<double>(rgba[i]) * 1000) / 1000);
  return out;
}

json shapesOf(const mjModel& m, int body) {
  json shapes = json::array();
  for (int i = 0; i < m.body_geomnum[body]; ++i) {
    const int g = m.body_geomadr[body] + i;
    const char* type = shapeName(m.geom_type[g]);
    if (m.geom_group[g] != kDrawnGroup || type == nullptr) continue;
    const int material = m.geom_matid[g];
    shapes.push_back({{"type", type},
                      {"size", list(m.geom_size + 3 * g, 3)},
                      {"pos", list(m.geom_pos + 3 * g, 3)},
                      {"quat", list(m.geom_quat + 4 * g, 4)},
                      {"colour", colourOf(m, g)},
                      {"glow", material < 0 ? 0.0 : rounded(static_cast<double>(m.mat_emission[material]))}});
  }
  return shapes;
}

// Null for the trunk, which has no joint.
json jointOf(const mjModel& m, const twin::BodyMap& map, int body) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (map.link[i] != body) continue;
    const int j = m.body_jntadr[body];
    return {{"name", kJointTable[i].name}, {"axis", list(m.jnt_axis + 3 * j, 3)}, {"pos", list(m.jnt_pos + 3 * j, 3)}};
  }
  return nullptr;
}

// Orientation of a sensor in the trunk, quaternion w x y z.
json sensorOf(const mjModel& m, int site) {
  return {{"quat", list(m.site_quat + 4 * site, 4)}};
}

}  // namespace

std::string bodyJson(const std::string& model) {
  const twin::Model read = twin::readModel(twin::findModel(model));
  const twin::MjModelPtr compiled = twin::loadBody(read, false);
  const mjModel& m = *compiled;
  const twin::BodyMap map = twin::mapBody(m, read.body.xml);
  json links = json::array();
  std::vector<int> place(static_cast<std::size_t>(m.nbody), -1);  // index in `links` by MuJoCo body
  for (int b = map.trunk; b < m.nbody; ++b) {
    if (m.body_rootid[b] != map.trunk) continue;
    place[static_cast<std::size_t>(b)] = static_cast<int>(links.size());
    links.push_back({{"name", mj_id2name(&m, mjOBJ_BODY, b)},
                     {"parent", b == map.trunk ? -1 : place[static_cast<std::size_t>(m.body_parentid[b])]},
                     {"pos", list(m.body_pos + 3 * b, 3)},
                     {"quat", list(m.body_quat + 4 * b, 4)},
                     {"joint", jointOf(m, map, b)},
                     {"shapes", shapesOf(m, b)}});
  }
  const json sensors{{"accelerometer", sensorOf(m, map.accelerometer)}, {"gyro", sensorOf(m, map.gyro)}};
  return json{{"model", read.name}, {"links", links}, {"sensors", sensors}}.dump();
}

}  // namespace darwinop::window
