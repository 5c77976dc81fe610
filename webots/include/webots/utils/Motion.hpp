// Plays a motion file. This version cannot yet: isValid() is false and nothing moves.
#ifndef MOTION_HPP
#define MOTION_HPP

#ifndef WB_USING_CPP_API
#define WB_USING_CPP_API
#endif

#include <string>

namespace webots {

class Motion {
 public:
  explicit Motion(const std::string& fileName);
  virtual ~Motion() {}
  bool isValid() const { return false; }
  virtual void play() {}
  virtual void stop() {}
  virtual void setLoop(bool) {}
  virtual void setReverse(bool) {}
  virtual void setTime(int) {}
  /// ms.
  int getDuration() const { return 0; }
  int getTime() const { return 0; }
  bool isOver() const { return true; }

 private:
  Motion(const Motion&);
  Motion& operator=(const Motion&);
};

}  // namespace webots

#endif
