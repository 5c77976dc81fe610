// The camera in the head, "Camera".
#ifndef CAMERA_HPP
#define CAMERA_HPP

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace darwinop {
namespace webots_api {
class CameraView;
}
}  // namespace darwinop

namespace webots {

/// One object of Camera::getRecognitionObjects(), as in simulation.
struct CameraRecognitionObject {
  int id;
  double position[3];        // from the camera, m
  double orientation[4];     // axis and angle, rad
  double size[2];            // width and height, m
  int position_on_image[2];  // centre, pixels
  int size_on_image[2];      // width and height, pixels
  int number_of_colors;
  double* colors;  // red, green, blue of each colour, 0 to 1
  char* model;
};

///     camera->enable(32);                              // ms
///     while (robot.step(16) != -1) {
///       const unsigned char* image = camera->getImage();
///       const int red = webots::Camera::imageGetRed(image, camera->getWidth(), 160, 120);
///     }
///
/// On a robot a V4L2 device; with `--robot twin` the twin's head camera in simulated time; none with `--robot virtual`.
/// Size, exposure and colour settings are in config.ini: docs/camera.md. Threads: see Robot; pictures are captured by a
/// thread of the library.
class Camera : public Device {
 public:
  /// Value of getType().
  enum { WB_CAMERA_COLOR = 99 };

  /// The robot's device of this name, for Robot::createCamera() and a class of your own; see Device.
  explicit Camera(const std::string& name);
  virtual ~Camera();
  /// Opens the camera, which takes a moment, and takes a new picture every `sampling_period` ms at the end of a
  /// step; the hardware has 30 pictures/s at most. 0 or less: disable(). A camera that cannot be opened logs one
  /// warning.
  virtual void enable(int sampling_period);
  /// Closes the camera.
  virtual void disable();
  /// ms as set last; 0: disabled.
  int getSamplingPeriod() const { return period_; }
  /// BGRA, 4 bytes per pixel, getWidth() x getHeight(), rows from top to bottom; unchanged until the next step (2013:
  /// overwritten at any time), which writes the next picture to the same address until disable(). NULL while disabled.
  /// Black until the first picture, and when none came for 2 s, so that a controller does not follow an old picture. A
  /// picture of another size is scaled, with one warning.
  const unsigned char* getImage() const;
  /// Pixels, as configured (2013: always 320).
  int getWidth() const;
  /// Pixels, as configured (2013: always 240).
  int getHeight() const;
  /// WB_CAMERA_COLOR, 99.
  int getType() const { return WB_CAMERA_COLOR; }
  /// Horizontal field of view, 1.0123 rad; the lens is fixed.
  double getFov() const { return 1.0123; }
  /// Same as getFov(); rad.
  double getMinFov() const { return getFov(); }
  /// Same as getFov(); rad.
  double getMaxFov() const { return getFov(); }
  /// Absent here: no effect, with one warning; rad.
  virtual void setFov(double fov);
  /// 0 m.
  double getNear() const { return 0; }
  /// Absent here: NaN, with one warning. Simulator: J/m2.
  double getExposure() const;
  /// Absent here: no effect, with one warning; set the exposure in config.ini, in 100 us.
  virtual void setExposure(double exposure);
  /// Absent here: 0 m, with one warning; not known.
  double getFocalLength() const;
  /// Absent here: 0 m, with one warning; the focus is fixed.
  double getFocalDistance() const;
  /// 0 m.
  double getMaxFocalDistance() const;
  /// 0 m.
  double getMinFocalDistance() const;
  /// Absent here: no effect, with one warning; m.
  virtual void setFocalDistance(double focal_distance);
  /// Absent here: writes no file and returns -1, with one warning; `quality` 1 to 100 is ignored.
  int saveImage(const std::string& filename, int quality) const;

  // Recognition of objects exists in the simulator only; DARwInOPVisionManager finds a ball by its colour.

  /// Absent here: false.
  bool hasRecognition() const { return false; }
  /// Absent here: no effect, with one warning; ms.
  virtual void recognitionEnable(int sampling_period);
  /// Absent here: no effect.
  virtual void recognitionDisable() {}
  /// Absent here: 0 ms, disabled.
  int getRecognitionSamplingPeriod() const { return 0; }
  /// Absent here: 0. Number of getRecognitionObjects().
  int getRecognitionNumberOfObjects() const { return 0; }
  /// Absent here: NULL.
  const CameraRecognitionObject* getRecognitionObjects() const { return 0; }
  /// Absent here: false.
  bool hasRecognitionSegmentation() const { return false; }
  /// Absent here: no effect, with one warning.
  void enableRecognitionSegmentation();
  /// Absent here: no effect.
  void disableRecognitionSegmentation() {}
  /// Absent here: false.
  bool isRecognitionSegmentationEnabled() const { return false; }
  /// Absent here: NULL. Simulator: BGRA, as getImage().
  const unsigned char* getRecognitionSegmentationImage() const { return 0; }
  /// Absent here: writes no file and returns -1, with one warning; `quality` 1 to 100 is ignored.
  int saveRecognitionSegmentationImage(const std::string& filename, int quality) const;

  /// Absent here: NULL. 2013: distances in m of a depth camera, today RangeFinder.
  const float* getRangeImage() const { return 0; }
  /// Absent here: 0 m, as getRangeImage().
  double getMaxRange() const { return 0; }
  /// Distance in m of pixel x, y of a range image that is `width` pixels wide. No range check.
  static float rangeImageGetDepth(const float* image, int width, int x, int y) { return image[y * width + x]; }

  /// Whether the robot's camera has this size in pixels; docs/camera.md lists the sizes.
  static bool checkResolution(int width, int height);
  /// Red, 0 to 255, of pixel x, y (0 at the top left) of a BGRA image that is `width` pixels wide. No range check.
  /// 2013: read RGB, which gave blue.
  static unsigned char imageGetRed(const unsigned char* image, int width, int x, int y) {
    return image[4 * (y * width + x) + 2];
  }
  /// Green, 0 to 255, as imageGetRed().
  static unsigned char imageGetGreen(const unsigned char* image, int width, int x, int y) {
    return image[4 * (y * width + x) + 1];
  }
  /// Blue, 0 to 255, as imageGetRed().
  static unsigned char imageGetBlue(const unsigned char* image, int width, int x, int y) {
    return image[4 * (y * width + x)];
  }
  /// Mean of the three colours, 0 to 255, each divided by 3 and rounded down; as imageGetRed().
  static unsigned char imageGetGray(const unsigned char* image, int width, int x, int y) {
    const unsigned char* pixel = image + 4 * (y * width + x);
    return static_cast<unsigned char>(pixel[2] / 3 + pixel[1] / 3 + pixel[0] / 3);
  }
  /// Same as imageGetGray(); 0 to 255.
  static unsigned char imageGetGrey(const unsigned char* image, int width, int x, int y) {
    return imageGetGray(image, width, x, y);
  }

 private:
  friend class darwinop::webots_api::RobotImpl;
  Camera(const std::string& name, darwinop::webots_api::RobotImpl& robot, int width, int height);
  Camera(const Camera&);
  Camera& operator=(const Camera&);
  virtual void refresh();
  int width_, height_, period_;
  double due_s_;                            // of the next picture; negative: at once
  darwinop::webots_api::CameraView* view_;  // NULL while disabled
};

}  // namespace webots

#endif
