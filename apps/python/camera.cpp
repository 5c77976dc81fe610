// Python class of the camera.
#include <webots/Camera.hpp>

#include "apps/python/bindings.hpp"

namespace darwinop::python {

namespace {

using webots::Camera;

constexpr int kBytesPerPixel = 4;

/// BGRA, rows from top to bottom; None while disabled. A copy, which the next step does not change.
py::object image(const Camera& camera) {
  const unsigned char* const pixels = camera.getImage();
  if (!pixels) return py::none();
  const auto size = static_cast<std::size_t>(camera.getWidth() * camera.getHeight() * kBytesPerPixel);
  return py::bytes{reinterpret_cast<const char*>(pixels), size};
}

/// image[x][y] is [red, green, blue]; None while disabled.
py::object imageArray(const Camera& camera) {
  const unsigned char* const pixels = camera.getImage();
  if (!pixels) return py::none();
  const int width = camera.getWidth(), height = camera.getHeight();
  py::list columns;
  for (int x = 0; x < width; ++x) {
    py::list column;
    for (int y = 0; y < height; ++y) {
      py::list pixel;
      pixel.append(Camera::imageGetRed(pixels, width, x, y));
      pixel.append(Camera::imageGetGreen(pixels, width, x, y));
      pixel.append(Camera::imageGetBlue(pixels, width, x, y));
      column.append(pixel);
    }
    columns.append(column);
  }
  return columns;
}

/// Camera.imageGetRed(image, width, x, y) and its siblings. IndexError outside of the image.
template <unsigned char (*Get)(const unsigned char*, int, int, int)>
int colour(const py::bytes& pixels, int width, int x, int y) {
  const auto text = static_cast<std::string_view>(pixels);
  if (x < 0 || x >= width || y < 0 ||
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x) + 1) *
              kBytesPerPixel >
          text.size())
    throw py::index_error("pixel " + std::to_string(x) + ", " + std::to_string(y) + " is outside of the image");
  return Get(reinterpret_cast<const unsigned char*>(text.data()), width, x, y);
}

using CameraClass = DeviceClass<Camera, webots::Device>;

template <unsigned char (*Get)(const unsigned char*, int, int, int)>
void bindColour(CameraClass& camera, const char* name) {
  camera.def_static(name, &colour<Get>, py::arg("image"), py::arg("width"), py::arg("x"), py::arg("y"));
}

void bindOptics(CameraClass& camera) {
  camera.def("setFov", &Camera::setFov, py::arg("fov"), kQuick);
  reads(camera, "getFov", &Camera::getFov, "setFov");
  reads(camera, "getMinFov", &Camera::getMinFov);
  reads(camera, "getMaxFov", &Camera::getMaxFov);
  reads(camera, "getNear", &Camera::getNear);
  camera.def("setExposure", &Camera::setExposure, py::arg("exposure"), kQuick);
  reads(camera, "getExposure", &Camera::getExposure, "setExposure");
  reads(camera, "getFocalLength", &Camera::getFocalLength);
  camera.def("setFocalDistance", &Camera::setFocalDistance, py::arg("focal_distance"), kQuick);
  reads(camera, "getFocalDistance", &Camera::getFocalDistance, "setFocalDistance");
  reads(camera, "getMinFocalDistance", &Camera::getMinFocalDistance);
  reads(camera, "getMaxFocalDistance", &Camera::getMaxFocalDistance);
}

/// Recognition and range images exist in simulation only.
void bindSimulatorOnly(CameraClass& camera) {
  camera.def("hasRecognition", &Camera::hasRecognition, kQuick);
  camera.def("recognitionEnable", &Camera::recognitionEnable, py::arg("sampling_period"), kQuick);
  camera.def("recognitionDisable", &Camera::recognitionDisable, kQuick);
  reads(camera, "getRecognitionSamplingPeriod", &Camera::getRecognitionSamplingPeriod);
  reads(camera, "getRecognitionNumberOfObjects", &Camera::getRecognitionNumberOfObjects);
  reads(camera, "getRecognitionObjects", [](const Camera&) { return py::list{}; });
  camera.def("hasRecognitionSegmentation", &Camera::hasRecognitionSegmentation, kQuick);
  camera.def("enableRecognitionSegmentation", &Camera::enableRecognitionSegmentation, kQuick);
  camera.def("disableRecognitionSegmentation", &Camera::disableRecognitionSegmentation, kQuick);
  camera.def("isRecognitionSegmentationEnabled", &Camera::isRecognitionSegmentationEnabled, kQuick);
  reads(camera, "getRecognitionSegmentationImage", [](const Camera&) { return py::none{}; });
  camera.def("saveRecognitionSegmentationImage", &Camera::saveRecognitionSegmentationImage, py::arg("filename"),
             py::arg("quality"), kQuick);
  reads(camera, "getRangeImage", [](const Camera&) { return py::none{}; });
  reads(camera, "getMaxRange", &Camera::getMaxRange);
  camera.def_static(
      "rangeImageGetDepth",
      [](const py::sequence& image, py::size_t width, py::size_t x, py::size_t y) {
        return py::object{image[y * width + x]};
      },
      py::arg("image"), py::arg("width"), py::arg("x"), py::arg("y"));
}

}  // namespace

void bindCamera(py::module_& module) {
  CameraClass camera{module, "Camera", py::dynamic_attr()};
  isMadeByName(camera);
  isSampled(camera, &Camera::enable, &Camera::disable, &Camera::getSamplingPeriod);
  reads(camera, "getImage", &image);
  reads(camera, "getImageArray", &imageArray);
  reads(camera, "getWidth", &Camera::getWidth);
  reads(camera, "getHeight", &Camera::getHeight);
  reads(camera, "getType", &Camera::getType);
  constants(camera, {{"WB_CAMERA_COLOR", Camera::WB_CAMERA_COLOR}});
  bindOptics(camera);
  camera.def("saveImage", &Camera::saveImage, py::arg("filename"), py::arg("quality"), kQuick);
  bindSimulatorOnly(camera);
  camera.def_static("checkResolution", &Camera::checkResolution, py::arg("width"), py::arg("height"));
  bindColour<&Camera::imageGetRed>(camera, "imageGetRed");
  bindColour<&Camera::imageGetGreen>(camera, "imageGetGreen");
  bindColour<&Camera::imageGetBlue>(camera, "imageGetBlue");
  bindColour<&Camera::imageGetGray>(camera, "imageGetGray");
  bindColour<&Camera::imageGetGrey>(camera, "imageGetGrey");
}

}  // namespace darwinop::python
