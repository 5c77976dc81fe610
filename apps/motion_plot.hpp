// `darwinop motion plot`: the goals of a page over time.
#pragma once

#include <string>

namespace darwinop::motion {

struct PlotRequest {
  std::string file;  // or "own"
  int page = 1;
  std::string out;             // .png or .html
  std::string from = "first";  // "first": the page's own first pose; "start": the robot's start pose
};

/// Throws std::runtime_error with a remedy.
int plotPage(const PlotRequest& request);

}  // namespace darwinop::motion
