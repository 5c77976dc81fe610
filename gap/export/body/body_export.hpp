// The model of a whole robot written for another simulator, with a list of what is lost.
#pragma once

#include "gap/export/targets.hpp"
#include "twin/model/model.hpp"

namespace darwinop::gap {

/// MuJoCo: the whole body with its servos as actuators. URDF: links with inertias and joints, without shapes. Webots:
/// the nodes with numbers, to be put into a PROTO of the robot and its world. `settings`: P register, temperature
/// and name of the model. Throws std::runtime_error if the body's file cannot be read, or for an impossible setting.
Export exportBody(Target target, const twin::Model& model, const ExportSettings& settings);

}  // namespace darwinop::gap
