// `darwinop twin view`: a robot on a pseudo terminal in real time, a controller that drives it, and a picture of it.
#pragma once

#include <string>
#include <vector>

#include "twin/render/scene.hpp"

namespace darwinop::twin {

struct ShowOptions {
  std::string model = "darwin-op";      // name or INI file
  std::vector<std::string> controller;  // and its arguments; empty: somebody else drives, or nobody
  std::string record;                   // film instead of a window, see film.hpp; empty: a window
  double seconds = 0;                   // of the robot's clock; 0: until the controller, the window or Ctrl-C ends it
  int width = 960, height = 720;
  int per_second = 30;  // pictures of a film
  Viewpoint from = Viewpoint::kFollow;
};

/// The exit status for the shell: the controller's if it ended by itself. Throws std::runtime_error.
int show(const ShowOptions& options);

}  // namespace darwinop::twin
