// Interposes the C library's open, close, ioctl and mmap for the camera device. All other calls are forwarded
// unchanged.
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "hil-mocks/camera/shim/device.hpp"
#include "hil-mocks/camera/shim/next.hpp"
#include "hil-mocks/camera/shim/paths.hpp"

namespace shim = darwinop::hil::shim;
using shim::the_camera;

namespace {

using Open = int(const char*, int, ...);
using OpenAt = int(int, const char*, int, ...);
using Map = void*(void*, size_t, int, int, int, off_t);
using OpenStream = FILE*(const char*, const char*);

constinit shim::Next<Open> next_open{"open"}, next_open64{"open64"};
constinit shim::Next<OpenAt> next_openat{"openat"}, next_openat64{"openat64"};
constinit shim::Next<int(int)> next_close{"close"};
constinit shim::Next<int(int, unsigned long, ...)> next_ioctl{"ioctl"};
constinit shim::Next<Map> next_mmap{"mmap"}, next_mmap64{"mmap64"};
constinit shim::Next<OpenStream> next_fopen{"fopen"}, next_fopen64{"fopen64"};

/// open() has a third argument only if it may create a file.
bool hasMode(int flags) {
  return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
}

void* map(shim::Next<Map>& next, void* address, size_t length, int protection, int flags, int fd, off_t offset) {
  if (!the_camera.owns(fd)) return next(address, length, protection, flags, fd, offset);
  const int memory = the_camera.memoryAt(length, static_cast<std::uint32_t>(offset));
  if (memory < 0) return MAP_FAILED;
  void* const mapped = next(address, length, protection, flags, memory, offset);
  next_close(memory);
  return mapped;
}

FILE* openDescription() {
  char text[128];
  const char* const slash = std::strrchr(shim::devicePath(), '/');
  const int length = std::snprintf(text, sizeof text, "MAJOR=%u\nMINOR=%u\nDEVNAME=%s\n", shim::kMajor, shim::kMinor,
                                   slash == nullptr ? shim::devicePath() : slash + 1);
  const int fd = memfd_create("uevent", MFD_CLOEXEC);
  if (fd < 0) return nullptr;
  if (write(fd, text, static_cast<size_t>(length)) != length || lseek(fd, 0, SEEK_SET) != 0) {
    next_close(fd);
    return nullptr;
  }
  return fdopen(fd, "r");
}

}  // namespace

#define DARWINOP_MODE(flags)     \
  mode_t mode = 0;               \
  if (hasMode(flags)) {          \
    va_list list;                \
    va_start(list, flags);       \
    mode = va_arg(list, mode_t); \
    va_end(list);                \
  }

DARWINOP_INTERPOSED int open(const char* path, int flags, ...) {
  DARWINOP_MODE(flags)
  return shim::isCamera(path) ? the_camera.open(flags) : next_open(path, flags, mode);
}

DARWINOP_INTERPOSED int open64(const char* path, int flags, ...) {
  DARWINOP_MODE(flags)
  return shim::isCamera(path) ? the_camera.open(flags) : next_open64(path, flags, mode);
}

DARWINOP_INTERPOSED int openat(int folder, const char* path, int flags, ...) {
  DARWINOP_MODE(flags)
  return shim::isCamera(path) ? the_camera.open(flags) : next_openat(folder, path, flags, mode);
}

DARWINOP_INTERPOSED int openat64(int folder, const char* path, int flags, ...) {
  DARWINOP_MODE(flags)
  return shim::isCamera(path) ? the_camera.open(flags) : next_openat64(folder, path, flags, mode);
}

// open() without mode in programs compiled with _FORTIFY_SOURCE.
// NOLINTBEGIN(readability-identifier-naming)
DARWINOP_INTERPOSED int __open_2(const char* path, int flags) {
  return open(path, flags);
}
DARWINOP_INTERPOSED int __open64_2(const char* path, int flags) {
  return open64(path, flags);
}
DARWINOP_INTERPOSED int __openat_2(int folder, const char* path, int flags) {
  return openat(folder, path, flags);
}
DARWINOP_INTERPOSED int __openat64_2(int folder, const char* path, int flags) {
  return openat64(folder, path, flags);
}
// NOLINTEND(readability-identifier-naming)

DARWINOP_INTERPOSED int close(int fd) {
  if (the_camera.owns(fd)) the_camera.closing(fd);
  return next_close(fd);
}

DARWINOP_INTERPOSED int ioctl(int fd, unsigned long request, ...) noexcept {
  va_list list;
  va_start(list, request);
  void* const argument = va_arg(list, void*);
  va_end(list);
  if (!the_camera.owns(fd)) return next_ioctl(fd, request, argument);
  const int error = the_camera.control(fd, static_cast<std::uint32_t>(request), argument);
  if (error == 0) return 0;
  errno = error;
  return -1;
}

DARWINOP_INTERPOSED void* mmap(void* address, size_t length, int protection, int flags, int fd, off_t offset) noexcept {
  return map(next_mmap, address, length, protection, flags, fd, offset);
}

DARWINOP_INTERPOSED void* mmap64(void* address, size_t length, int protection, int flags, int fd,
                                 off64_t offset) noexcept {
  return map(next_mmap64, address, length, protection, flags, fd, offset);
}

DARWINOP_INTERPOSED FILE* fopen(const char* path, const char* mode) {
  return shim::isDescription(path) ? openDescription() : next_fopen(path, mode);
}

DARWINOP_INTERPOSED FILE* fopen64(const char* path, const char* mode) {
  return shim::isDescription(path) ? openDescription() : next_fopen64(path, mode);
}
