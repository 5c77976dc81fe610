// Interactive window of the twin's scene.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "twin/render/scene.hpp"

namespace darwinop::twin {

/// A window cannot be opened; the message contains the reason.
struct NoDisplay : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Actions of keys that act on the robot.
struct WindowKeys {
  std::function<void()> push, reset;
};

/// Use from the main thread only, one window at a time.
class ViewWindow {
 public:
  /// Throws NoDisplay.
  ViewWindow(const mjModel_& model, int width, int height, const std::string& title, WindowKeys keys);
  ~ViewWindow();

  [[nodiscard]] Scene& scene() noexcept;
  /// Sets the text at the top left.
  void setLine(const std::string& line);
  /// Processes keyboard and mouse events.
  void pollEvents();
  /// True once the user has closed it.
  [[nodiscard]] bool closed() const noexcept;
  void draw();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace darwinop::twin
