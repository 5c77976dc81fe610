// Finds a ball, or anything else, by its colour: docs/vision.md.
#ifndef DARWIN_OP_VISION_MANAGER_HPP
#define DARWIN_OP_VISION_MANAGER_HPP

namespace managers {

class DARwInOPVisionManager {
 public:
  /// Size of the image in pixels, hue in degrees (0..360) and how far from it (0..180) excluding both ends, the
  /// greatest saturation and value in percent that are too little (0..100), and the share of the image in percent that
  /// is too little and the one that is just not too much (0..100). What is out of range is said and brought into it.
  DARwInOPVisionManager(int width, int height, int hue, int hueTolerance, int minSaturation, int minValue,
                        int minPercent, int maxPercent);
  DARwInOPVisionManager(const DARwInOPVisionManager& other);
  DARwInOPVisionManager& operator=(const DARwInOPVisionManager& other);
  virtual ~DARwInOPVisionManager();

  /// True: x and y are the centre in whole pixels, from the top left corner. False: there is none; x and y are then 0.
  /// The image is BGRA, 4 bytes a pixel, of the size given above; it is read during the call only. NULL: false.
  bool getBallCenter(double& x, double& y, const unsigned char* image);
  /// Whether the last getBallCenter() took this pixel for the ball's. False outside of the image.
  bool isDetected(int x, int y);

  // In force from the next getBallCenter().
  void setHue(int hue);
  void setHueTolerance(int hueTolerance);
  void setMinSaturation(int minSaturation);
  void setMinValue(int minValue);
  void setMinPercent(int minPercent);
  void setmaxPercent(int maxPercent);

 private:
  struct Eye;
  Eye* eye_;  // never NULL
};

}  // namespace managers

#endif
