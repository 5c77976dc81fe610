// Interposes a test between the program and its camera driver.
#pragma once

namespace darwinop::v4l2 {

class Quirk {
 public:
  Quirk() = default;
  virtual ~Quirk() = default;
  Quirk(const Quirk&) = delete;
  Quirk& operator=(const Quirk&) = delete;
  /// Replaces ioctl(). Any thread.
  virtual int call(int fd, unsigned long request, void* argument) = 0;
  /// The original ioctl(), or the virtual camera's.
  static int next(int fd, unsigned long request, void* argument);
};

/// Activates a quirk during its lifetime; one at a time. A camera may abandon a thread: the destructor waits until no
/// call is inside the quirk.
class InForce {
 public:
  explicit InForce(Quirk& quirk);
  ~InForce();
  InForce(const InForce&) = delete;
  InForce& operator=(const InForce&) = delete;
};

}  // namespace darwinop::v4l2
