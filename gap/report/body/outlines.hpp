// What one sees of the twin's body from a side: convex outlines, the farthest first.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::gap {

/// Axes of the picture in the world (x forward, y left, z up), unit vectors; `towards`: the viewer.
struct View {
  Eigen::Vector3d right, up, towards;

  [[nodiscard]] Eigen::Vector2d of(const Eigen::Vector3d& point) const { return {right.dot(point), up.dot(point)}; }
};

struct Outline {
  std::string link;                      // "AnkleR", by its joint; "Body"
  std::vector<Eigen::Vector2d> corners;  // m, anticlockwise
  double depth = 0;                      // m along View::towards
};

/// `d` after mj_kinematics.
std::vector<Outline> outlinesOf(const mjModel& m, const mjData& d, const twin::BodyMap& map, const View& view);

}  // namespace darwinop::gap
