// Python class of .motion files.
#include <webots/utils/Motion.hpp>

#include "apps/python/bindings.hpp"

namespace darwinop::python {

using webots::Motion;

void bindMotion(py::module_& module) {
  OwnedClass<Motion> motion{module, "Motion", py::dynamic_attr()};
  motion.def(py::init<const std::string&>(), py::arg("fileName"), kQuick);
  reads(motion, "isValid", &Motion::isValid);
  motion.def("play", &Motion::play, kQuick);
  motion.def("stop", &Motion::stop, kQuick);
  motion.def("setLoop", &Motion::setLoop, py::arg("loop"), kQuick);
  motion.def("setReverse", &Motion::setReverse, py::arg("reverse"), kQuick);
  motion.def("setTime", &Motion::setTime, py::arg("time"), kQuick);
  reads(motion, "getDuration", &Motion::getDuration);
  reads(motion, "getTime", &Motion::getTime, "setTime");
  reads(motion, "isOver", &Motion::isOver);
}

}  // namespace darwinop::python
