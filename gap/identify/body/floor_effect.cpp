#include "gap/identify/body/floor_effect.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gap/thresholds.hpp"
#include "twin/body/mujoco_model.hpp"

namespace darwinop::gap {
namespace {

using FloorNumber = FloorEffect::Number;
using FloorValues = std::vector<double>;

Eigen::Vector3d vectorFrom(const FloorValues& values, std::size_t first = 0) {
  return {values[first], values[first + 1], values[first + 2]};
}

/// One number on a logarithmic scale.
FloorEffect scaleAt(std::string_view id, std::string_view at, FloorNumber number, double neutral,
                    const FloorValues& factors, std::function<void(FloorModel&, double)> apply) {
  number.is_logarithmic = true, number.step = 0.05;
  FloorEffect out{.id = id, .at = at, .numbers = {number}, .neutral = {neutral}, .starts = {}, .apply = {}};
  for (const double factor : factors) out.starts.push_back({factor * neutral});
  out.apply = [apply = std::move(apply)](FloorModel& model, const FloorValues& values) { apply(model, values[0]); };
  return out;
}

/// Starts that move one number each.
std::vector<FloorValues> oneByOne(const FloorValues& neutral, std::size_t first, double by) {
  std::vector<FloorValues> out;
  for (std::size_t i = first; i < neutral.size(); ++i) {
    out.push_back(neutral);
    out.back()[i] += by;
  }
  return out;
}

std::vector<FloorEffect> contactEffects(const twin::Model& model) {
  const double friction = model.body.floor_friction, time_s = model.body.contact_time_s;
  std::vector<FloorEffect> out;
  out.push_back(scaleAt("floor_friction", "floor", {.key = "friction", .unit = "", .low = 0.02, .high = 5, .step = 0},
                        friction, {0.2, 0.35, 0.6},
                        [friction](FloorModel& m, double value) { m.robot.floor.friction_factor = value / friction; }));
  out.push_back(scaleAt("contact_time", "floor", {.key = "time", .unit = "s", .low = 0.002, .high = 0.2, .step = 0},
                        time_s, {0.4, 2.5, 5},
                        [time_s](FloorModel& m, double value) { m.robot.floor.contact_time_factor = value / time_s; }));
  out.back().of_engine = EngineNumber::kContactTime;
  out.back().engine_sigma = std::log(1 + thresholds::kEngineContactTime);
  out.push_back(scaleAt("sole_size", "floor", {.key = "scale", .unit = "", .low = 0.3, .high = 2, .step = 0}, 1,
                        {0.6, 0.8, 1.25}, [](FloorModel& m, double value) { m.robot.floor.sole_scale = value; }));
  const FloorNumber tilt{.key = "tilt", .unit = "rad", .low = -0.3, .high = 0.3, .step = 0.002, .prior_sigma = 0.1};
  out.push_back({.id = "floor_tilt",
                 .at = "floor",
                 .is_linear = true,
                 .is_of_load = true,
                 .numbers = {tilt, tilt},
                 .neutral = {0, 0},
                 .starts = oneByOne({0, 0}, 0, 0.02),
                 .apply = [](FloorModel& m, const FloorValues& values) {
                   m.robot.floor.tilt_rad = {values[0], values[1]};
                 }});
  return out;
}

std::vector<FloorEffect> trunkEffects(const twin::Model& model) {
  const twin::MjModelPtr compiled = twin::loadBody(model, false);
  const mjtNum* const com = compiled->body_ipos + 3 * twin::mapBody(*compiled, model.body.xml).trunk;
  const FloorNumber shift{.key = "shift", .unit = "m", .low = -0.15, .high = 0.15, .step = 0.001, .prior_sigma = 0.04};
  std::vector<FloorNumber> numbers{
      {.key = "mass", .unit = "kg", .low = -0.5, .high = 2, .step = 0.02, .prior_sigma = 0.3}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    numbers.push_back(shift);
    numbers.back().key = "point", numbers.back().shown_offset = com[axis];
  }
  std::vector<FloorEffect> out;
  out.push_back({.id = "link_mass",
                 .at = "Body",
                 .is_of_load = true,
                 .numbers = numbers,
                 .neutral = {0, 0, 0, 0},
                 .starts = {{0.1, 0, 0, 0}, {0.3, 0, 0, 0}, {0.15, 0, 0, 0.04}, {0.15, 0, 0, -0.04}},
                 .apply = [](FloorModel& m, const FloorValues& values) {
                   m.robot.floor.trunk_mass_kg = values[0];
                   m.robot.floor.trunk_from_com_m = vectorFrom(values, 1);
                 }});
  out.push_back({.id = "link_com",
                 .at = "Body",
                 .is_linear = true,
                 .is_of_load = true,
                 .numbers = {shift, shift, shift},
                 .neutral = {0, 0, 0},
                 .starts = oneByOne({0, 0, 0}, 0, 0.005),
                 .apply = [](FloorModel& m, const FloorValues& values) {
                   m.robot.floor.trunk_com_shift_m = vectorFrom(values);
                 }});
  return out;
}

/// The 47 signed permutations of three axes that change something.
std::vector<FloorValues> axisMapsOfGyro() {
  std::vector<FloorValues> maps;
  FloorValues axes{1, 2, 3};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      FloorValues map = axes;
      for (std::size_t i = 0; i < 3; ++i)
        if ((signs >> i & 1U) != 0) map[i] = -map[i];
      if (map != FloorValues{1, 2, 3}) maps.push_back(map);
    }
  } while (std::ranges::next_permutation(axes).found);
  return maps;
}

std::vector<FloorEffect> gyroEffects() {
  std::vector<FloorEffect> out;
  const FloorNumber scale{.key = "scale",
                          .unit = "",
                          .low = -3,
                          .high = 3,
                          .step = 0.01,
                          .prior_sigma = thresholds::kGyroScale,
                          .prior_mean = 1};
  out.push_back({.id = "gyro_scale",
                 .at = "gyro",
                 .is_of_sensor = true,
                 .is_linear = true,
                 .numbers = {scale, scale, scale},
                 .neutral = {1, 1, 1},
                 .starts = oneByOne({1, 1, 1}, 0, 0.1),
                 .apply = [](FloorModel& m, const FloorValues& values) { m.imu.gyro.scale = vectorFrom(values); }});
  const FloorNumber axis{.key = "map", .unit = "", .low = -3, .high = 3, .step = 1, .is_fixed = true};
  out.push_back({.id = "gyro_axes",
                 .at = "gyro",
                 .is_of_sensor = true,
                 .numbers = {axis, axis, axis},
                 .neutral = {1, 2, 3},
                 .starts = axisMapsOfGyro(),
                 .apply = [](FloorModel& m, const FloorValues& values) {
                   m.imu.gyro.map.setZero();
                   for (Eigen::Index i = 0; i < 3; ++i) {
                     const double of = values[static_cast<std::size_t>(i)];
                     m.imu.gyro.map(i, static_cast<Eigen::Index>(std::abs(of)) - 1) = of > 0 ? 1 : -1;
                   }
                 }});
  out.push_back(scaleAt("gyro_lowpass", "gyro", {.key = "time", .unit = "s", .low = 0.0005, .high = 1, .step = 0},
                        0.001, {5, 15, 40, 100}, [](FloorModel& m, double value) { m.imu.lowpass_s = value; }));
  out.push_back(scaleAt("gyro_range", "gyro", {.key = "range", .unit = "rad/s", .low = 0.05, .high = 35, .step = 0}, 30,
                        {0.01, 0.02, 0.035, 0.06, 0.1},
                        [](FloorModel& m, double value) { m.imu.range_rad_s = value; }));
  out.push_back(scaleAt("imu_delay", "imu", {.key = "delay", .unit = "s", .low = 0.0005, .high = 0.3, .step = 0}, 0.001,
                        {5, 12, 25, 50}, [](FloorModel& m, double value) { m.imu.delay_s = value; }));
  for (FloorEffect& effect : out) effect.is_of_sensor = true;
  return out;
}

}  // namespace

double PlacedFloor::costAmongEngines() const {
  if (effect->of_engine == EngineNumber::kNone) return std::numeric_limits<double>::infinity();
  const FloorEffect::Number& number = effect->numbers.front();
  return std::pow((number.inSearch(values.front()) - number.inSearch(effect->neutral.front())) / effect->engine_sigma,
                  2);
}

std::vector<FloorEffect> floorEffects(const twin::Model& model) {
  std::vector<FloorEffect> out = contactEffects(model);
  for (auto& group : {trunkEffects(model), gyroEffects()}) out.insert(out.end(), group.begin(), group.end());
  return out;
}

}  // namespace darwinop::gap
