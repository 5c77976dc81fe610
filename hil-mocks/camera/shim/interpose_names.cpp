// Interposes stat and its relatives, so that the camera device appears to exist.
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "hil-mocks/camera/shim/device.hpp"
#include "hil-mocks/camera/shim/next.hpp"
#include "hil-mocks/camera/shim/paths.hpp"

namespace darwinop::hil::shim {

const char* devicePath() {
  const char* const path = std::getenv("DARWINOP_VIRTUAL_CAMERA_DEVICE");
  return path == nullptr || *path == '\0' ? "/dev/video0" : path;
}

bool isCamera(const char* path) {
  return path != nullptr && std::getenv("DARWINOP_VIRTUAL_CAMERA") != nullptr && std::strcmp(path, devicePath()) == 0;
}

bool isDescription(const char* path) {
  return path != nullptr && std::strcmp(path, "/sys/dev/char/81:0/uevent") == 0 && isCamera(devicePath());
}

}  // namespace darwinop::hil::shim

namespace shim = darwinop::hil::shim;

namespace {

using Stat = int(const char*, struct stat*);
using Stat64 = int(const char*, struct stat64*);

constinit shim::Next<Stat> next_stat{"stat"}, next_lstat{"lstat"};
constinit shim::Next<Stat64> next_stat64{"stat64"}, next_lstat64{"lstat64"};
constinit shim::Next<int(int, struct stat*)> next_fstat{"fstat"};
constinit shim::Next<int(int, struct stat64*)> next_fstat64{"fstat64"};
constinit shim::Next<int(int, const char*, struct stat*, int)> next_fstatat{"fstatat"};
constinit shim::Next<int(int, const char*, struct stat64*, int)> next_fstatat64{"fstatat64"};
constinit shim::Next<int(const char*, int)> next_access{"access"}, next_euidaccess{"euidaccess"},
    next_eaccess{"eaccess"};
constinit shim::Next<int(int, const char*, int, int)> next_faccessat{"faccessat"};

template <class Status>
int describeDevice(Status* status) {
  *status = {};
  status->st_mode = S_IFCHR | 0660;
  status->st_nlink = 1;
  status->st_rdev = makedev(shim::kMajor, shim::kMinor);
  return 0;
}

int failed(int error) {
  errno = error;
  return -1;
}

template <class Status>
int describePath(Status* status) {
  return shim::the_camera.fault() == darwinop::hil::CameraFault::kGone ? failed(ENOENT) : describeDevice(status);
}

int checkAccess(int mode) {
  const darwinop::hil::CameraFault fault = shim::the_camera.fault();
  if (fault == darwinop::hil::CameraFault::kGone) return failed(ENOENT);
  const bool refused = (fault == darwinop::hil::CameraFault::kNoAccess && mode != F_OK) || (mode & X_OK) != 0;
  return refused ? failed(EACCES) : 0;
}

}  // namespace

DARWINOP_INTERPOSED int stat(const char* path, struct stat* status) noexcept {
  return shim::isCamera(path) ? describePath(status) : next_stat(path, status);
}
DARWINOP_INTERPOSED int stat64(const char* path, struct stat64* status) noexcept {
  return shim::isCamera(path) ? describePath(status) : next_stat64(path, status);
}
DARWINOP_INTERPOSED int lstat(const char* path, struct stat* status) noexcept {
  return shim::isCamera(path) ? describePath(status) : next_lstat(path, status);
}
DARWINOP_INTERPOSED int lstat64(const char* path, struct stat64* status) noexcept {
  return shim::isCamera(path) ? describePath(status) : next_lstat64(path, status);
}
DARWINOP_INTERPOSED int fstat(int fd, struct stat* status) noexcept {
  return shim::the_camera.owns(fd) ? describeDevice(status) : next_fstat(fd, status);
}
DARWINOP_INTERPOSED int fstat64(int fd, struct stat64* status) noexcept {
  return shim::the_camera.owns(fd) ? describeDevice(status) : next_fstat64(fd, status);
}
DARWINOP_INTERPOSED int fstatat(int folder, const char* path, struct stat* status, int flags) noexcept {
  return shim::isCamera(path) ? describePath(status) : next_fstatat(folder, path, status, flags);
}
DARWINOP_INTERPOSED int fstatat64(int folder, const char* path, struct stat64* status, int flags) noexcept {
  return shim::isCamera(path) ? describePath(status) : next_fstatat64(folder, path, status, flags);
}

DARWINOP_INTERPOSED int access(const char* path, int mode) noexcept {
  return shim::isCamera(path) ? checkAccess(mode) : next_access(path, mode);
}
DARWINOP_INTERPOSED int euidaccess(const char* path, int mode) noexcept {
  return shim::isCamera(path) ? checkAccess(mode) : next_euidaccess(path, mode);
}
DARWINOP_INTERPOSED int eaccess(const char* path, int mode) noexcept {
  return shim::isCamera(path) ? checkAccess(mode) : next_eaccess(path, mode);
}
DARWINOP_INTERPOSED int faccessat(int folder, const char* path, int mode, int flags) noexcept {
  return shim::isCamera(path) ? checkAccess(mode) : next_faccessat(folder, path, mode, flags);
}
