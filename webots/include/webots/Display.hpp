// Drawing surface of the simulator. This robot has none: absent_devices.hpp.
#ifndef DISPLAY_HPP
#define DISPLAY_HPP

#include <webots/absent_devices.hpp>

namespace webots {

class Camera;
class ImageRef;

/// No object exists here: Robot::getDisplay() returns NULL. Coordinates are pixels from the top left corner.
class Display : public Device {
 public:
  /// Pixel formats of imageNew().
  enum { RGB = 3, RGBA = 4, ARGB = 5, BGRA = 6, ABGR = 7 };

  /// Pixels.
  virtual int getWidth() const = 0;
  /// Pixels.
  virtual int getHeight() const = 0;
  /// Colour of the calls below, 0 to 0xFFFFFF, 0xRRGGBB.
  virtual void setColor(int color) = 0;
  /// Transparency that the calls below write, 0 to 1; 0: transparent.
  virtual void setAlpha(double alpha) = 0;
  /// Share of the new colour in the calls below, 0 to 1.
  virtual void setOpacity(double opacity) = 0;
  /// Font of drawText(); `size` in pixels.
  virtual void setFont(const std::string& font, int size, bool anti_aliasing) = 0;
  /// One pixel.
  virtual void drawPixel(int x, int y) = 0;
  /// Line between two pixels.
  virtual void drawLine(int x1, int y1, int x2, int y2) = 0;
  /// Outline; pixels.
  virtual void drawRectangle(int x, int y, int width, int height) = 0;
  /// Outline around the centre; half axes a, b in pixels.
  virtual void drawOval(int cx, int cy, int a, int b) = 0;
  /// Outline through `size` corners; pixels.
  virtual void drawPolygon(const int* x, const int* y, int size) = 0;
  /// Text from this pixel.
  virtual void drawText(const std::string& text, int x, int y) = 0;
  /// As drawRectangle(), filled.
  virtual void fillRectangle(int x, int y, int width, int height) = 0;
  /// As drawOval(), filled.
  virtual void fillOval(int cx, int cy, int a, int b) = 0;
  /// As drawPolygon(), filled.
  virtual void fillPolygon(const int* x, const int* y, int size) = 0;
  /// Image from pixels in memory; `format` as above.
  virtual ImageRef* imageNew(int width, int height, const void* data, int format) const = 0;
  /// Image from a part of the surface; pixels.
  virtual ImageRef* imageCopy(int x, int y, int width, int height) const = 0;
  /// Image from a file.
  virtual ImageRef* imageLoad(const std::string& filename) const = 0;
  /// Draws an image with its top left corner at this pixel.
  virtual void imagePaste(ImageRef* image, int x, int y, bool blend = false) = 0;
  /// Writes an image, or with NULL the surface, to a file.
  virtual void imageSave(ImageRef* image, const std::string& filename) const = 0;
  /// Frees an image.
  virtual void imageDelete(ImageRef* image) const = 0;
  /// Shows the pictures of a camera below what is drawn.
  virtual void attachCamera(Camera* camera) = 0;
  /// Ends attachCamera().
  virtual void detachCamera() = 0;
};

}  // namespace webots

#endif
