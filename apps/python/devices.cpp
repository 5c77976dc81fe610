// Python classes of lights, buttons and the board's sensors.
#include <webots/Accelerometer.hpp>
#include <webots/Gyro.hpp>
#include <webots/LED.hpp>
#include <webots/TouchSensor.hpp>

#include "apps/python/bindings.hpp"

namespace darwinop::python {

namespace {

using namespace webots;

/// A list of `size` numbers, as upstream's Python API returns them; a copy of the newest values.
py::list listOf(const double* values, int size) {
  py::list list;
  for (int i = 0; i < size; ++i) list.append(values[i]);
  return list;
}

/// Accelerometer or gyroscope.
template <class Sensor>
void bindThreeAxes(py::module_& module, const char* name) {
  DeviceClass<Sensor, Device> sensor{module, name, py::dynamic_attr()};
  isMadeByName(sensor);
  isSampled(sensor, &Sensor::enable, &Sensor::disable, &Sensor::getSamplingPeriod);
  reads(sensor, "getValues", [](const Sensor& self) { return listOf(self.getValues(), 3); });
  reads(sensor, "getLookupTable",
        [](const Sensor& self) { return listOf(self.getLookupTable(), 3 * self.getLookupTableSize()); });
  reads(sensor, "getLookupTableSize", &Sensor::getLookupTableSize);
}

/// A device of a class that this robot has none of. apps/python/controller/absent.py has the classes.
class AbsentDevice : public Device {
 public:
  AbsentDevice(const std::string& type, const std::string& name) : Device(name, type.c_str()) {}
};

}  // namespace

void bindDevices(py::module_& module) {
  DeviceClass<Device> device{module, "Device", py::dynamic_attr()};
  reads(device, "getName", &Device::getName);
  reads(device, "getModel", &Device::getModel);
  reads(device, "getNodeType", &Device::getNodeType);
  reads(device, "getType", &Device::getType);
  reads(device, "getTag", &Device::getTag);

  OwnedClass<AbsentDevice, Device> absent{module, "AbsentDevice", py::dynamic_attr()};
  absent.def(py::init<const std::string&, const std::string&>(), py::arg("type"), py::arg("name"), kQuick);

  DeviceClass<LED, Device> led{module, "LED", py::dynamic_attr()};
  isMadeByName(led);
  led.def("set", &LED::set, py::arg("value"), kQuick);
  led.def("get", &LED::get, kQuick);
  led.attr("value") = py::module_::import("builtins").attr("property")(led.attr("get"), led.attr("set"));

  DeviceClass<TouchSensor, Device> button{module, "TouchSensor", py::dynamic_attr()};
  isMadeByName(button);
  isSampled(button, &TouchSensor::enable, &TouchSensor::disable, &TouchSensor::getSamplingPeriod);
  reads(button, "getValue", &TouchSensor::getValue);
  reads(button, "getValues", [](const TouchSensor& self) {
    self.getValues();  // warns
    return py::none{};
  });
  reads(button, "getLookupTableSize", &TouchSensor::getLookupTableSize);
  reads(button, "getLookupTable", [](const TouchSensor&) { return py::list{}; });
  reads(button, "getType", [](const TouchSensor& self) { return static_cast<int>(self.getType()); });
  constants(button,
            {{"BUMPER", TouchSensor::BUMPER}, {"FORCE", TouchSensor::FORCE}, {"FORCE3D", TouchSensor::FORCE3D}});

  bindThreeAxes<Accelerometer>(module, "Accelerometer");
  bindThreeAxes<Gyro>(module, "Gyro");
}

}  // namespace darwinop::python
