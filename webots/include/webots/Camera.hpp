// The camera in the head, "Camera".
#ifndef CAMERA_HPP
#define CAMERA_HPP

#include <webots/Device.hpp>

namespace darwinop {
namespace facade {
class CameraView;
}
}  // namespace darwinop

namespace webots {

/// Sizes, settings and what the messages mean: docs/camera.md.
class Camera : public Device {
 public:
  enum { WB_CAMERA_COLOR = 99 };

  virtual ~Camera();
  /// A new picture every so many ms, at the end of a step; the camera itself takes 30 a second, or fewer.
  virtual void enable(int sampling_period);
  virtual void disable();
  int getSamplingPeriod() const { return period_; }
  /// BGRA, 4 bytes a pixel, rows from top to bottom, valid until the next step. NULL while disabled. All black until
  /// the first picture has come, and again while the camera has been silent for 2 s: nothing is to be followed then.
  const unsigned char* getImage() const;
  int getWidth() const;
  int getHeight() const;
  int getType() const { return WB_CAMERA_COLOR; }
  /// rad, horizontal.
  double getFov() const { return 1.0123; }
  double getMinFov() const { return getFov(); }
  double getMaxFov() const { return getFov(); }
  virtual void setFov(double fov);
  double getNear() const { return 0; }
  double getExposure() const;
  virtual void setExposure(double exposure);
  double getFocalLength() const;
  double getFocalDistance() const;
  double getMaxFocalDistance() const;
  double getMinFocalDistance() const;
  virtual void setFocalDistance(double focal_distance);
  /// -1: not in this version, no file is written.
  int saveImage(const std::string& filename, int quality) const;

  /// The simulator recognises objects of its world; a robot's camera does not.
  bool hasRecognition() const { return false; }
  bool hasRecognitionSegmentation() const { return false; }

  /// Sizes that the robot's camera can deliver.
  static bool checkResolution(int width, int height);
  static unsigned char imageGetRed(const unsigned char* image, int width, int x, int y) {
    return image[4 * (y * width + x) + 2];
  }
  static unsigned char imageGetGreen(const unsigned char* image, int width, int x, int y) {
    return image[4 * (y * width + x) + 1];
  }
  static unsigned char imageGetBlue(const unsigned char* image, int width, int x, int y) {
    return image[4 * (y * width + x)];
  }
  static unsigned char imageGetGray(const unsigned char* image, int width, int x, int y) {
    const unsigned char* pixel = image + 4 * (y * width + x);
    return static_cast<unsigned char>(pixel[2] / 3 + pixel[1] / 3 + pixel[0] / 3);
  }
  static unsigned char imageGetGrey(const unsigned char* image, int width, int x, int y) {
    return imageGetGray(image, width, x, y);
  }

 private:
  friend class darwinop::facade::RobotImpl;
  Camera(const std::string& name, darwinop::facade::RobotImpl& robot, int width, int height);
  Camera(const Camera&);
  Camera& operator=(const Camera&);
  void refresh(double time_s);
  int width_, height_, period_;
  double due_s_;                        // of the next picture; negative: at once
  darwinop::facade::CameraView* view_;  // NULL while disabled
};

}  // namespace webots

#endif
