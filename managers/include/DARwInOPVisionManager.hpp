// Finds a ball by its colour. This version cannot yet: there never is one.
#ifndef DARWIN_OP_VISION_MANAGER_HPP
#define DARWIN_OP_VISION_MANAGER_HPP

namespace managers {

class DARwInOPVisionManager {
 public:
  DARwInOPVisionManager(int width, int height, int hue, int hueTolerance, int minSaturation, int minValue,
                        int minPercent, int maxPercent);
  virtual ~DARwInOPVisionManager() {}
  /// False: no ball; x and y are then 0.
  bool getBallCenter(double& x, double& y, const unsigned char* image);
  bool isDetected(int, int) { return false; }
  void setHue(int) {}
  void setHueTolerance(int) {}
  void setMinSaturation(int) {}
  void setMinValue(int) {}
  void setMinPercent(int) {}
  void setmaxPercent(int) {}
};

}  // namespace managers

#endif
