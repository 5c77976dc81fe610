// Loads libEGL at run time and creates a surfaceless OpenGL context.
#include "twin/render/egl.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace darwinop::twin {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw NoGraphics(why + ". Install OpenGL: apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri");
}

/// Never closed: MuJoCo and the driver keep pointers into it.
void* library() {
  static void* const handle = dlopen("libEGL.so.1", RTLD_NOW | RTLD_GLOBAL);
  return handle;
}

}  // namespace

struct EglContext::Library {
  decltype(&eglGetProcAddress) get_proc_address = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglBindAPI) bind_api = nullptr;
  decltype(&eglChooseConfig) choose_config = nullptr;
  decltype(&eglCreateContext) create_context = nullptr;
  decltype(&eglMakeCurrent) make_current = nullptr;
  decltype(&eglDestroyContext) destroy_context = nullptr;
  decltype(&eglGetError) get_error = nullptr;

  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  template <class F>
  static void find(F& function, const char* name) {
    function = reinterpret_cast<F>(dlsym(library(), name));
    if (function == nullptr) refuse(std::string{"libEGL has no "} + name);
  }

  Library() {
    if (library() == nullptr) refuse("libEGL.so.1 is not installed");
    find(get_proc_address, "eglGetProcAddress");
    find(initialize, "eglInitialize");
    find(bind_api, "eglBindAPI");
    find(choose_config, "eglChooseConfig");
    find(create_context, "eglCreateContext");
    find(make_current, "eglMakeCurrent");
    find(destroy_context, "eglDestroyContext");
    find(get_error, "eglGetError");
  }

  [[noreturn]] void fail(const char* what) const {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%s failed with EGL error 0x%x", what, static_cast<unsigned>(get_error()));
    refuse(text.data());
  }

  void open() {
    // Mesa's surfaceless platform needs no display, window or device permission.
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get_proc_address("eglGetPlatformDisplayEXT"));
    if (platform_display == nullptr) refuse("libEGL has no eglGetPlatformDisplayEXT");
    display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display == EGL_NO_DISPLAY || initialize(display, nullptr, nullptr) == EGL_FALSE) fail("opening a display");
    if (bind_api(EGL_OPENGL_API) == EGL_FALSE) fail("choosing OpenGL");
    // The default of EGL_SURFACE_TYPE is a window, which this platform does not have.
    static constexpr std::array<EGLint, 13> kWanted{EGL_SURFACE_TYPE,
                                                    EGL_PBUFFER_BIT,
                                                    EGL_RENDERABLE_TYPE,
                                                    EGL_OPENGL_BIT,
                                                    EGL_RED_SIZE,
                                                    8,
                                                    EGL_GREEN_SIZE,
                                                    8,
                                                    EGL_BLUE_SIZE,
                                                    8,
                                                    EGL_DEPTH_SIZE,
                                                    24,
                                                    EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (choose_config(display, kWanted.data(), &config, 1, &count) == EGL_FALSE || count == 0) fail("choosing colours");
    context = create_context(display, config, EGL_NO_CONTEXT, nullptr);
    if (context == EGL_NO_CONTEXT) fail("making a context");
  }
};

EglContext::EglContext() {
  const char* const setting = std::getenv("DARWINOP_TWIN_GL");
  if (setting != nullptr && std::string{setting} == "off") throw NoGraphics("switched off by DARWINOP_TWIN_GL=off");
  egl_ = std::make_unique<Library>();
  egl_->open();
  use();
}

EglContext::~EglContext() {
  release();
  egl_->destroy_context(egl_->display, egl_->context);
  // The display is not terminated: it is shared by the process, and another context may use it.
}

bool EglContext::tryUse() noexcept {
  return egl_->make_current(egl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl_->context) != EGL_FALSE;
}

void EglContext::use() {
  if (!tryUse()) egl_->fail("activating a context without a window");
}

void EglContext::release() noexcept {
  egl_->make_current(egl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace darwinop::twin
