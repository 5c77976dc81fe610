// A window in which the robot is seen, turned and pushed.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "twin/render/scene.hpp"

namespace darwinop::twin {

/// No window can be opened here; the text says why.
struct NoDisplay : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Keys that concern the robot, not the picture.
struct WindowKeys {
  std::function<void()> push, reset;
};

/// One at a time, in the main thread.
class Window {
 public:
  /// Throws NoDisplay.
  Window(const mjModel_& model, int width, int height, const std::string& title, WindowKeys keys);
  ~Window();

  [[nodiscard]] Scene& scene() noexcept;
  /// One line at the top left.
  void say(const std::string& line);
  /// Takes keys and mouse.
  void listen();
  /// True once the user closed it.
  [[nodiscard]] bool closed() const noexcept;
  void draw();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace darwinop::twin
