// OpenGL without a display: a context of EGL that has no window. libEGL is looked for at run time, so that the twin
// runs on a PC that has none; it sees nothing then.
#pragma once

#include <memory>
#include <stdexcept>

namespace darwinop::twin {

/// There is no OpenGL here; the text says why, and what to install.
struct NoGraphics : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class EglContext {
 public:
  /// Throws NoGraphics. DARWINOP_TWIN_GL=off in the environment: always.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// What is drawn from now on by this thread is drawn here. Another thread must have let go of it before.
  void use();
  /// The same; false: refused, and nothing may be drawn.
  [[nodiscard]] bool tryUse() noexcept;
  /// This thread draws nowhere.
  void letGo() noexcept;

 private:
  struct Library;
  std::unique_ptr<Library> egl_;
};

}  // namespace darwinop::twin
