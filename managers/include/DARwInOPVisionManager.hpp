// Finds a ball, or any object, by its colour. docs/vision.md explains how to choose the parameters.
#ifndef DARWIN_OP_VISION_MANAGER_HPP
#define DARWIN_OP_VISION_MANAGER_HPP

namespace managers {

///     managers::DARwInOPVisionManager ball(320, 240, 28, 20, 50, 45, 0, 30);   // orange
///     double x, y;
///     if (ball.getBallCenter(x, y, camera->getImage())) follow(x, y);          // pixels
///
/// Thresholds hue, saturation and value, erodes and dilates by 3x3, and returns the mean of the remaining pixels: two
/// balls give one centre between them. Simulator and 2013: the same result to the pixel; 2013 read memory beside the
/// mask. Errors are logged once on stderr, nothing is thrown. Threads: objects are independent; one object is not
/// thread-safe.
class DARwInOPVisionManager {
 public:
  /// Image size in pixels, 1 to 16384; the other parameters as in the setters below. An impossible size logs one
  /// warning, and nothing is ever found.
  DARwInOPVisionManager(int width, int height, int hue, int hueTolerance, int minSaturation, int minValue,
                        int minPercent, int maxPercent);
  /// An independent copy with the same parameters.
  DARwInOPVisionManager(const DARwInOPVisionManager& other);
  /// As the copy constructor.
  DARwInOPVisionManager& operator=(const DARwInOPVisionManager& other);
  virtual ~DARwInOPVisionManager();

  /// True: x and y are the centre in whole pixels from the top left corner. False: nothing found; x and y are then 0.
  /// `image` is BGRA, 4 bytes per pixel, of the size given to the constructor; it is read during the call only. NULL:
  /// false, with one warning.
  bool getBallCenter(double& x, double& y, const unsigned char* image);
  /// Whether the last getBallCenter() counted pixel x, y as part of the ball. False outside of the image.
  bool isDetected(int x, int y);

  // In force from the next getBallCenter(). Numbers out of range are clamped (hue wraps), with one warning per
  // parameter.

  /// Middle of the hue range in degrees, 0 to 360: red 0, yellow 60, green 120, cyan 180, blue 240, magenta 300.
  void setHue(int hue);
  /// Half width of the hue range in degrees, 0 to 180, both ends excluded: 0 and 180 match nothing.
  void setHueTolerance(int hueTolerance);
  /// Saturation in percent, -1 to 100, that a pixel has to exceed; -1: any.
  void setMinSaturation(int minSaturation);
  /// Value in percent, -1 to 100, that a pixel has to exceed; -1: any. Grey pixels have saturation 0 and value 0 here.
  void setMinValue(int minValue);
  /// Share of the image in percent, 0 to 100, that the pixels have to exceed.
  void setMinPercent(int minPercent);
  /// Share of the image in percent, 0 to 100, that the pixels must not exceed. The name is upstream's.
  void setmaxPercent(int maxPercent);

 private:
  struct Impl;
  Impl* impl_;  // never NULL
};

}  // namespace managers

#endif
