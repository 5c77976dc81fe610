// Python class of the vision manager.
#include <RobotisOp2VisionManager.hpp>
#include <stdexcept>

#include "apps/python/bindings.hpp"
#include "apps/python/messages.hpp"

namespace darwinop::python {

namespace {

/// Knows the size of its images, so that a short one is refused instead of read beyond its end.
class PythonVision : public managers::RobotisOp2VisionManager {
 public:
  PythonVision(int width, int height, int hue, int hue_tolerance, int min_saturation, int min_value, int min_percent,
               int max_percent)
      : RobotisOp2VisionManager{width, height, hue, hue_tolerance, min_saturation, min_value, min_percent, max_percent},
        bytes_{4 * py::ssize_t{width} * height} {}

  /// (found, x, y). `image`: what Camera.getImage() returns, or any object with as many bytes; None: nothing is found.
  py::tuple ballCentre(const py::object& image) {
    double x = 0, y = 0;
    bool found = false;
    if (image.is_none()) {
      found = getBallCenter(x, y, nullptr);
    } else {
      const py::buffer_info pixels = py::buffer{image}.request();
      const bool contiguous = PyBuffer_IsContiguous(pixels.view(), 'C') != 0;
      if (!contiguous || pixels.size * pixels.itemsize < bytes_) throw py::value_error(messages::kImageTooSmall);
      found = getBallCenter(x, y, static_cast<const unsigned char*>(pixels.ptr));
    }
    return py::make_tuple(found, x, y);
  }

 private:
  py::ssize_t bytes_;
};

}  // namespace

void bindVision(py::module_& module) {
  using Vision = PythonVision;
  py::class_<Vision> vision{module, "RobotisOp2VisionManager", py::dynamic_attr()};
  vision.def(py::init<int, int, int, int, int, int, int, int>(), py::arg("width"), py::arg("height"), py::arg("hue"),
             py::arg("hueTolerance"), py::arg("minSaturation"), py::arg("minValue"), py::arg("minPercent"),
             py::arg("maxPercent"));
  vision.def("getBallCenter", &Vision::ballCentre, py::arg("image"));
  vision.def("isDetected", &Vision::isDetected, py::arg("x"), py::arg("y"));
  vision.def("setHue", &Vision::setHue, py::arg("hue"));
  vision.def("setHueTolerance", &Vision::setHueTolerance, py::arg("hueTolerance"));
  vision.def("setMinSaturation", &Vision::setMinSaturation, py::arg("minSaturation"));
  vision.def("setMinValue", &Vision::setMinValue, py::arg("minValue"));
  vision.def("setMinPercent", &Vision::setMinPercent, py::arg("minPercent"));
  vision.def("setmaxPercent", &Vision::setmaxPercent, py::arg("maxPercent"));
  module.attr("DARwInOPVisionManager") = vision;
}

}  // namespace darwinop::python
