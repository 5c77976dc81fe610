// Where in a robot something acts or is measured.
#pragma once

#include <cstdint>
#include <string>

namespace darwinop::gap {

struct Place {
  enum class Kind : std::uint8_t { kJoint, kLink, kSensor, kContact };
  Kind kind = Kind::kJoint;
  std::string name = {};  // "AnkleR", "gyro", "floor"; empty: the only one of a plant with one place

  bool operator==(const Place&) const = default;
};

}  // namespace darwinop::gap
