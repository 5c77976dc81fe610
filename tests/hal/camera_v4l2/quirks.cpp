// An ioctl() before that of the virtual camera.
#include "hal/camera_v4l2/quirks.hpp"

#include <dlfcn.h>
#include <sys/ioctl.h>

#include <atomic>
#include <chrono>
#include <cstdarg>
#include <thread>

namespace darwinop::v4l2 {
namespace {

std::atomic<Quirk*> in_force{nullptr};
std::atomic<int> inside{0};

}  // namespace

InForce::InForce(Quirk& quirk) {
  in_force.store(&quirk);
}
InForce::~InForce() {
  in_force.store(nullptr);
  while (inside.load() != 0) std::this_thread::sleep_for(std::chrono::milliseconds{1});
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
  darwinop::v4l2::inside.fetch_add(1);  // first: whoever waits for us to leave sees us, or we see that it is over
  Quirk* const quirk = darwinop::v4l2::in_force.load();
  const int result = quirk != nullptr ? quirk->call(fd, request, argument) : Quirk::next(fd, request, argument);
  darwinop::v4l2::inside.fetch_sub(1);
  return result;
}
