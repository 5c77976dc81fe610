// Drawing surface of the simulator. This robot has none: absent_devices.hpp.
#ifndef DISPLAY_HPP
#define DISPLAY_HPP

#include <webots/absent_devices.hpp>

namespace webots {

class Camera;
class ImageRef;

/// Robot::getDisplay() returns NULL; an object that a controller makes has no device: see Device. Coordinates are
/// pixels from the top left corner.
class Display : public Device {
 public:
  /// Pixel formats of imageNew().
  enum { RGB = 3, RGBA = 4, ARGB = 5, BGRA = 6, ABGR = 7 };

  /// An object without a device, for Robot::createDisplay() and a class of your own; logs one warning. See Device.
  explicit Display(const std::string& name) : Device(name, "Display") {}
  /// Absent here: 0. Simulator: pixels.
  int getWidth() const { return 0; }
  /// Absent here: 0. Simulator: pixels.
  int getHeight() const { return 0; }
  /// Absent here: no effect. Simulator: colour of the calls below, 0 to 0xFFFFFF, 0xRRGGBB.
  virtual void setColor(int /*color*/) {}
  /// Absent here: no effect. Simulator: transparency that the calls below write, 0 to 1; 0: transparent.
  virtual void setAlpha(double /*alpha*/) {}
  /// Absent here: no effect. Simulator: share of the new colour in the calls below, 0 to 1.
  virtual void setOpacity(double /*opacity*/) {}
  /// Absent here: no effect. Simulator: font of drawText(); `size` in pixels.
  virtual void setFont(const std::string& /*font*/, int /*size*/, bool /*anti_aliasing*/) {}
  /// Absent here: no effect. Simulator: one pixel.
  virtual void drawPixel(int /*x*/, int /*y*/) {}
  /// Absent here: no effect. Simulator: line between two pixels.
  virtual void drawLine(int /*x1*/, int /*y1*/, int /*x2*/, int /*y2*/) {}
  /// Absent here: no effect. Simulator: outline; pixels.
  virtual void drawRectangle(int /*x*/, int /*y*/, int /*width*/, int /*height*/) {}
  /// Absent here: no effect. Simulator: outline around the centre; half axes a, b in pixels.
  virtual void drawOval(int /*cx*/, int /*cy*/, int /*a*/, int /*b*/) {}
  /// Absent here: no effect. Simulator: outline through `size` corners; pixels.
  virtual void drawPolygon(const int* /*x*/, const int* /*y*/, int /*size*/) {}
  /// Absent here: no effect. Simulator: text from this pixel.
  virtual void drawText(const std::string& /*text*/, int /*x*/, int /*y*/) {}
  /// Absent here: no effect. Simulator: as drawRectangle(), filled.
  virtual void fillRectangle(int /*x*/, int /*y*/, int /*width*/, int /*height*/) {}
  /// Absent here: no effect. Simulator: as drawOval(), filled.
  virtual void fillOval(int /*cx*/, int /*cy*/, int /*a*/, int /*b*/) {}
  /// Absent here: no effect. Simulator: as drawPolygon(), filled.
  virtual void fillPolygon(const int* /*x*/, const int* /*y*/, int /*size*/) {}
  /// Absent here: NULL. Simulator: image from pixels in memory; `format` as above.
  ImageRef* imageNew(int /*width*/, int /*height*/, const void* /*data*/, int /*format*/) const { return 0; }
  /// Absent here: NULL. Simulator: image from a part of the surface; pixels.
  ImageRef* imageCopy(int /*x*/, int /*y*/, int /*width*/, int /*height*/) const { return 0; }
  /// Absent here: NULL. Simulator: image from a file.
  ImageRef* imageLoad(const std::string& /*filename*/) const { return 0; }
  /// Absent here: no effect. Simulator: draws an image with its top left corner at this pixel.
  virtual void imagePaste(ImageRef* /*image*/, int /*x*/, int /*y*/, bool /*blend*/ = false) {}
  /// Absent here: no effect. Simulator: writes an image, or with NULL the surface, to a file.
  void imageSave(ImageRef* /*image*/, const std::string& /*filename*/) const {}
  /// Absent here: no effect. Simulator: frees an image.
  void imageDelete(ImageRef* /*image*/) const {}
  /// Absent here: no effect. Simulator: shows the pictures of a camera below what is drawn.
  virtual void attachCamera(Camera* /*camera*/) {}
  /// Absent here: no effect. Simulator: ends attachCamera().
  virtual void detachCamera() {}
};

}  // namespace webots

#endif
