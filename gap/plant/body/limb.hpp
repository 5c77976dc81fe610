// Arms, legs and head of a robot as chains of links. While the trunk is clamped, they do not act on each other.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "core/joints.hpp"
#include "twin/body/link_inertia.hpp"
#include "twin/model/model.hpp"

namespace darwinop::gap {

/// A link and the hinge that carries it. Its frame has its origin on the hinge's axis. SI units.
struct Link : twin::LinkInertia {
  Joint joint{};
  int parent = -1;                   // index in the limb; -1: the trunk
  Eigen::Vector3d origin;            // in the parent's frame
  Eigen::Matrix3d rotation;          // of the link's frame to the parent's where the joint is at 0
  Eigen::Vector3d axis;              // unit vector, in the link's frame
  double low_rad = 0, high_rad = 0;  // mechanical stops, true angles
};

/// In the order from the trunk outward: a link follows its parent.
using Limb = std::vector<Link>;

/// Of the model's MuJoCo file. Throws std::runtime_error, a sentence with the file, where a hinge does not lead to the
/// trunk, or its axis is off its link's origin.
std::vector<Limb> limbsOf(const twin::Model& model);
/// kg, of the trunk without limbs.
double trunkMass(const twin::Model& model);

}  // namespace darwinop::gap
