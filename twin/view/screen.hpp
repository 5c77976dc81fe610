// Where the robot is seen: a window, or a film.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "twin/view/pose_ring.hpp"
#include "twin/view/show.hpp"
#include "twin/view/window.hpp"

struct mjModel_;

namespace darwinop::twin {

class Screen {
 public:
  virtual ~Screen() = default;
  /// Poses a second that it wants.
  [[nodiscard]] virtual int perSecond() const = 0;
  /// Draws what has come; at most a few pictures, so that the caller gets round. True: something was drawn.
  virtual bool draw(PoseRing& poses, const std::string& line) = 0;
  /// The user, or the length that was asked for, ends it.
  [[nodiscard]] virtual bool full() = 0;
  /// The robot has stopped: draws what is left and puts everything away. `hurry` is asked before every picture.
  virtual void finish(PoseRing& poses, const std::function<bool()>& hurry) = 0;
};

/// Throws NoDisplay, NoGraphics, std::runtime_error.
std::unique_ptr<Screen> makeScreen(const ShowOptions& options, const mjModel_& model, WindowKeys keys);

}  // namespace darwinop::twin
