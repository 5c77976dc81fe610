// Lets a test stand between a program and its camera's driver, to be a driver of another kind.
#pragma once

namespace darwinop::v4l2 {

/// In force while it lives; one at a time. It must outlive the cameras that it meets.
class Quirk {
 public:
  Quirk();
  virtual ~Quirk();
  Quirk(const Quirk&) = delete;
  Quirk& operator=(const Quirk&) = delete;
  /// Any thread: instead of ioctl().
  virtual int call(int fd, unsigned long request, void* argument) = 0;
  /// The real one, or the virtual camera's.
  static int next(int fd, unsigned long request, void* argument);
};

}  // namespace darwinop::v4l2
