// OpenGL context without a display (surfaceless EGL). libEGL is loaded at run time, so the twin also runs without it,
// then without camera pictures.
#pragma once

#include <memory>
#include <stdexcept>

namespace darwinop::twin {

/// OpenGL is not available; the message contains the reason and the packages to install.
struct NoGraphics : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class EglContext {
 public:
  /// Throws NoGraphics, always if DARWINOP_TWIN_GL=off is in the environment.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// Makes the context current on this thread. It must not be current on another thread.
  void use();
  /// The same; false on failure.
  [[nodiscard]] bool tryUse() noexcept;
  /// Makes no context current on this thread.
  void release() noexcept;

 private:
  struct Library;
  std::unique_ptr<Library> egl_;
};

}  // namespace darwinop::twin
