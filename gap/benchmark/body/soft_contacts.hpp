// Contacts of the robot's links with the floor as bounded springs and dampers at the corners of their boxes.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "gap/benchmark/body/soft_rows.hpp"
#include "twin/body/mujoco_model.hpp"

namespace darwinop::gap {

struct ContactNumbers {
  double stiffness_n_m, damping_ns_m, friction;
};

class SoftContacts {
 public:
  /// Of every geom that the model pairs with the floor.
  SoftContacts(const mjModel& m, const twin::BodyMap& map);

  /// Three rows for each point that is in the floor: upward, then two sideways. Requires current kinematics. `first`:
  /// degree of freedom from which on the robot moves.
  void addTo(std::vector<SoftRow>& rows, const mjModel& m, const mjData& d, int first, const ContactNumbers& numbers);
  /// After a step with these rows, of which the last are those that were added.
  void keepBends(const std::vector<SoftRow>& rows);

 private:
  /// A point of a link that may touch the floor.
  struct Feeler {
    int geom, body;
    Eigen::Vector3d at;  // in the geom's frame
    double radius;
    Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  // bend of its sideways springs
    bool touched = false;
  };
  std::vector<Feeler> feelers_;
  std::vector<std::size_t> touching_;  // feelers in the order of their rows
};

}  // namespace darwinop::gap
