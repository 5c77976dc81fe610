// Python class of the loudspeaker.
#include <webots/Speaker.hpp>

#include "apps/python/bindings.hpp"

namespace darwinop::python {

using webots::Speaker;

void bindSpeaker(py::module_& module) {
  DeviceClass<Speaker, webots::Device> speaker{module, "Speaker", py::dynamic_attr()};
  isMadeByName(speaker);
  speaker.def_static("playSound", &Speaker::playSound, py::arg("left").none(true), py::arg("right").none(true),
                     py::arg("sound"), py::arg("volume"), py::arg("pitch"), py::arg("balance"), py::arg("loop"),
                     kWaiting);
  speaker.def("stop", &Speaker::stop, py::arg("sound") = "", kQuick);
  speaker.def("isSoundPlaying", &Speaker::isSoundPlaying, py::arg("sound") = "", kQuick);
  speaker.def("setEngine", &Speaker::setEngine, py::arg("engine"), kQuick);
  speaker.def("setLanguage", &Speaker::setLanguage, py::arg("language"), kQuick);
  reads(speaker, "getEngine", &Speaker::getEngine, "setEngine");
  reads(speaker, "getLanguage", &Speaker::getLanguage, "setLanguage");
  speaker.def("speak", py::overload_cast<const std::string&, double>(&Speaker::speak), py::arg("text"),
              py::arg("volume"), kWaiting);
  reads(speaker, "isSpeaking", &Speaker::isSpeaking);

  // Calls of 2013.
  speaker.def("enable", &Speaker::enable, py::arg("sampling_period"), kQuick);
  speaker.def("disable", &Speaker::disable, kQuick);
  speaker.def("playFile", &Speaker::playFile, py::arg("filename"), kWaiting);
  speaker.def("playFileWait", &Speaker::playFileWait, py::arg("filename"), kWaiting);
  speaker.def("speak", py::overload_cast<const char*, const char*, int>(&Speaker::speak), py::arg("text"),
              py::arg("voice") = "en", py::arg("speed") = 175, kWaiting);
  speaker.def("speakFile", &Speaker::speakFile, py::arg("filename"), py::arg("voice") = "en", py::arg("speed") = 175,
              kWaiting);
}

}  // namespace darwinop::python
