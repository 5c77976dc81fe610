// `darwinop twin view`: a virtual robot on a pseudo terminal in real time, its controller, and a window or film of it.
#pragma once

#include <string>
#include <vector>

#include "twin/render/scene.hpp"

namespace darwinop::twin {

struct ShowOptions {
  std::string model = "darwin-op";      // name or INI file
  std::vector<std::string> controller;  // and arguments; empty: start none
  std::string record;                   // film path, see film.hpp; empty: a window
  double seconds = 0;                   // of the robot's clock; 0: until controller, window or Ctrl-C end it
  int width = 960, height = 720;
  int per_second = 30;  // pictures of a film
  Viewpoint from = Viewpoint::kFollow;
};

/// Returns the exit status: the controller's if it ended by itself, else 0. Throws std::runtime_error.
int show(const ShowOptions& options);

}  // namespace darwinop::twin
