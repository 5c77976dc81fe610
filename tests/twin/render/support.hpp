// Shared helpers of the rendering tests.
#pragma once

#include <cstdlib>
#include <string>

#include "twin/body/robot_body.hpp"
#include "twin/model/model.hpp"
#include "twin/render/picture.hpp"

namespace darwinop::twin {

inline RobotBody usualBody() {
  return RobotBody{readModel(findModel("darwin-op"))};
}

inline int red(const RenderedPicture& p, int x, int y) {
  return p.at(x, y)[0];
}
inline int green(const RenderedPicture& p, int x, int y) {
  return p.at(x, y)[1];
}
inline int blue(const RenderedPicture& p, int x, int y) {
  return p.at(x, y)[2];
}

struct Spot {
  double x = 0, y = 0;
  int pixels = 0;
};

/// Centroid of all pixels for which `is` returns true.
template <class Is>
Spot centreOf(const RenderedPicture& p, Is&& is) {
  Spot spot;
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x)
      if (is(x, y)) {
        spot.x += x;
        spot.y += y;
        ++spot.pixels;
      }
  if (spot.pixels > 0) {
    spot.x /= spot.pixels;
    spot.y /= spot.pixels;
  }
  return spot;
}

/// Sets an environment variable for one test.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_{name} {
    if (const char* const before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Environment() {
    if (before_.empty())
      unsetenv(name_);
    else
      setenv(name_, before_.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::string before_;
};

}  // namespace darwinop::twin
