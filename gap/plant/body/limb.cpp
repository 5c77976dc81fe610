#include "gap/plant/body/limb.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::gap {
namespace {

constexpr double kOffAxis = 1e-6;  // m

Eigen::Vector3d vectorAt(const mjtNum* values) {
  return {values[0], values[1], values[2]};
}

Eigen::Matrix3d rotationAt(const mjtNum* quat) {
  return Eigen::Quaterniond{quat[0], quat[1], quat[2], quat[3]}.normalized().toRotationMatrix();
}

Link linkOf(const mjModel& m, int body, Joint joint, const std::string& file) {
  const int hinge = m.body_jntadr[body];
  if (m.body_jntnum[body] != 1 || vectorAt(m.jnt_pos + 3 * hinge).norm() > kOffAxis)
    throw std::runtime_error(file + ": body " + std::string{row(joint).name} +
                             " needs one hinge through its origin; move the origin of the body to the axis");
  Link link;
  link.joint = joint;
  link.origin = vectorAt(m.body_pos + 3 * body);
  link.rotation = rotationAt(m.body_quat + 4 * body);
  link.axis = vectorAt(m.jnt_axis + 3 * hinge).normalized();
  link.low_rad = m.jnt_range[2 * hinge], link.high_rad = m.jnt_range[2 * hinge + 1];
  static_cast<twin::LinkInertia&>(link) = twin::inertiaOfLink(m, body);
  return link;
}

}  // namespace

std::vector<Limb> limbsOf(const twin::Model& model) {
  const twin::MjModelPtr compiled = twin::loadBody(model, false);
  const mjModel& m = *compiled;
  const std::string& file = model.body.xml;
  const twin::BodyMap map = twin::mapBody(m, file);
  const auto jointOf = [&](int body) {
    const auto found = std::ranges::find(map.link, body);
    if (found == map.link.end())
      throw std::runtime_error(file +
                               ": a body between trunk and joints has no joint of the robot; attach its mass to "
                               "its neighbour");
    return static_cast<Joint>(found - map.link.begin());
  };
  std::vector<int> bodies(map.link.begin(), map.link.end());
  std::ranges::sort(bodies);  // MuJoCo numbers a parent before its children
  std::vector<Limb> limbs;
  std::map<int, std::pair<std::size_t, int>> place;  // limb and index of a body
  for (const int body : bodies) {
    const int parent = m.body_parentid[body];
    Link link = linkOf(m, body, jointOf(body), file);
    std::size_t limb = limbs.size();
    if (parent == map.trunk)
      limbs.emplace_back();
    else if (const auto found = place.find(parent); found != place.end())
      limb = found->second.first, link.parent = found->second.second;
    else
      (void)jointOf(parent);
    place[body] = {limb, static_cast<int>(limbs[limb].size())};
    limbs[limb].push_back(std::move(link));
  }
  return limbs;
}

double trunkMass(const twin::Model& model) {
  const twin::MjModelPtr compiled = twin::loadBody(model, false);
  return compiled->body_mass[twin::mapBody(*compiled, model.body.xml).trunk];
}

}  // namespace darwinop::gap
