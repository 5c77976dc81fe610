// An ioctl() before that of the virtual camera.
#include "hal_camera_v4l2/quirks.hpp"

#include <dlfcn.h>
#include <sys/ioctl.h>

#include <atomic>
#include <cstdarg>

namespace darwinop::v4l2 {
namespace {

std::atomic<Quirk*> in_force{nullptr};

}  // namespace

Quirk::Quirk() {
  in_force.store(this);
}
Quirk::~Quirk() {
  in_force.store(nullptr);
}

int Quirk::next(int fd, unsigned long request, void* argument) {
  using Ioctl = int(int, unsigned long, ...);
  static Ioctl* const behind = reinterpret_cast<Ioctl*>(dlsym(RTLD_NEXT, "ioctl"));
  return behind(fd, request, argument);
}

}  // namespace darwinop::v4l2

extern "C" int ioctl(int fd, unsigned long request, ...) noexcept {
  va_list list;
  va_start(list, request);
  void* const argument = va_arg(list, void*);
  va_end(list);
  using darwinop::v4l2::Quirk;
  Quirk* const quirk = darwinop::v4l2::in_force.load();
  return quirk != nullptr ? quirk->call(fd, request, argument) : Quirk::next(fd, request, argument);
}
