// Lets a test stand between a program and its camera's driver, to be a driver of another kind.
#pragma once

namespace darwinop::v4l2 {

class Quirk {
 public:
  Quirk() = default;
  virtual ~Quirk() = default;
  Quirk(const Quirk&) = delete;
  Quirk& operator=(const Quirk&) = delete;
  /// Any thread: instead of ioctl().
  virtual int call(int fd, unsigned long request, void* argument) = 0;
  /// The real one, or the virtual camera's.
  static int next(int fd, unsigned long request, void* argument);
};

/// Puts a quirk in force while it lives; one at a time. A camera may leave a thread behind: the end waits until no call
/// is inside the quirk, which must still be whole then.
class InForce {
 public:
  explicit InForce(Quirk& quirk);
  ~InForce();
  InForce(const InForce&) = delete;
  InForce& operator=(const InForce&) = delete;
};

}  // namespace darwinop::v4l2
