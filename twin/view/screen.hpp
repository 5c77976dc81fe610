// Output of the view: a window, or a film.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "twin/view/pose_ring.hpp"
#include "twin/view/show.hpp"
#include "twin/view/window.hpp"

struct mjModel_;

namespace darwinop::twin {

class ViewOutput {
 public:
  virtual ~ViewOutput() = default;
  /// Required pose rate, 1/s.
  [[nodiscard]] virtual int posesPerSecond() const = 0;
  /// Draws at most one new picture; returns quickly. True if something was drawn.
  virtual bool draw(PoseRing& poses, const std::string& line) = 0;
  /// True once the user has closed it or the requested length is reached.
  [[nodiscard]] virtual bool isFinished() = 0;
  /// After the robot has stopped: draws the remaining poses and closes the output. Skips the rest if `hurry` returns
  /// true.
  virtual void finish(PoseRing& poses, const std::function<bool()>& hurry) = 0;
};

/// Throws NoDisplay, NoGraphics, std::runtime_error.
std::unique_ptr<ViewOutput> makeScreen(const ShowOptions& options, const mjModel_& model, WindowKeys keys);

}  // namespace darwinop::twin
