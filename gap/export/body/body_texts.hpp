// Writers of a whole robot in the three formats.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "gap/export/texts.hpp"
#include "twin/body/link_inertia.hpp"
#include "twin/body/mujoco_model.hpp"

namespace darwinop::gap {

/// What is written: the compiled body with all changes of the model, and the numbers of its servos.
struct BodyText {
  const twin::Model& model;
  const ExportSettings& settings;
  mjModel& body;
  twin::BodyMap map;
  std::vector<ServoNumbers> servos;  // by joint

  [[nodiscard]] twin::LinkInertia link(std::size_t link) const;
  /// Orientation of a joint's link in its parent where the encoder reads 0: w x y z. An encoder offset turns it.
  [[nodiscard]] std::array<double, 4> atZero(std::size_t joint) const;
};

std::string mujocoBody(const BodyText& of, const std::vector<std::string>& comments);
std::string webotsBody(const BodyText& of, const std::vector<std::string>& comments);
std::string urdfBody(const BodyText& of, const std::vector<std::string>& comments);

/// "0.1 -0.2 0"
std::string threeNumbers(const double* values);

}  // namespace darwinop::gap
