// What the tests of whole robots for other simulators share: models, and MuJoCo as a reader.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <fstream>
#include <string>

#include "gap/export/body/body_export.hpp"
#include "support/temporary_folder.hpp"
#include "twin/body/mujoco_model.hpp"

namespace darwinop::gap {

/// The shipped robot with these lines.
inline twin::Model robotWith(const std::string& lines) {
  return twin::parseModel("[model]\nname = robot\n" + lines, "robot.ini");
}

inline twin::MjModelPtr loadedByMujoco(const std::string& xml, const std::string& suffix = ".xml") {
  const TemporaryFolder folder;
  const std::string path = folder / ("robot" + suffix);
  std::ofstream{path} << xml;
  char why[500] = "";
  twin::MjModelPtr model{mj_loadXML(path.c_str(), nullptr, why, sizeof why)};
  EXPECT_NE(model, nullptr) << why;
  return model;
}

}  // namespace darwinop::gap
