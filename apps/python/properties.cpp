// Properties of the classes: the getters without "get", in both spellings.
#include <cctype>
#include <string_view>

#include "apps/python/bindings.hpp"

namespace darwinop::python {

namespace {

/// Calls the getter. Without __set__, so that a controller's class may have an attribute of the same name, for example
/// self.keyboard.
struct Reading {
  py::object getter;
};

/// "getMinPosition", "isValid" -> "minPosition", "valid"
std::string camelCase(std::string_view getter) {
  for (const std::string_view start : {"get", "is", "has"})
    if (getter.starts_with(start)) {
      getter.remove_prefix(start.size());
      break;
    }
  std::string name{getter};
  // A name that begins with an abbreviation keeps its capitals: getLED.
  if (name.size() < 2 || std::islower(static_cast<unsigned char>(name[1])) != 0)
    name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
  return name;
}

std::string snakeCase(const std::string& camel) {
  std::string name;
  for (const char letter : camel) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isupper(code) != 0) name += '_';
    name += static_cast<char>(std::tolower(code));
  }
  return name;
}

}  // namespace

void addProperty(const py::handle& type, const std::string& getter, const char* setter) {
  const py::object get = type.attr(getter.c_str());
  const py::object property =
      setter ? py::module_::import("builtins").attr("property")(get, type.attr(setter)) : py::cast(Reading{get});
  const std::string camel = camelCase(getter);
  type.attr(camel.c_str()) = property;
  type.attr(snakeCase(camel).c_str()) = property;
}

void bindProperties(py::module_& module) {
  py::class_<Reading>(module, "Reading")
      .def(
          "__get__",
          [](py::object self, const py::object& object, const py::object&) {
            return object.is_none() ? self : self.cast<Reading&>().getter(object);
          },
          py::arg("object").none(true), py::arg("type") = py::none());
  module.def(
      "add_property", [](const py::object& type, const std::string& getter) { addProperty(type, getter); },
      py::arg("type"), py::arg("getter"));
}

}  // namespace darwinop::python
