// A model: everything that a calibration may change about the robot, as one INI file says it. The shape of the body is
// in the MuJoCo file that it names. docs/twin/models.md shows the format.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/joints.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

/// An effect that is switched on, in all servos or in one.
struct EffectSetting {
  const EffectInfo* info = nullptr;
  std::vector<double> values;  // one per parameter of info
  std::optional<Joint> joint;  // nothing: all joints; a joint's own setting replaces the common one
};

/// Which of the contradicting facts about the trunk is believed; docs/twin/body.md.
enum class TrunkCom { kManufacturer, kWebots2013, kHalfway };
enum class TrunkInertia { kBox, kPublished };

struct BodySettings {
  std::string xml = "darwin-op.xml";  // beside the INI file
  TrunkCom trunk_com = TrunkCom::kHalfway;
  TrunkInertia trunk_inertia = TrunkInertia::kBox;
  bool self_collision = false;
  bool hold_until_driven = false;  // a joint that was never switched on keeps its angle
  double floor_friction = 1.0;     // Coulomb coefficient, as the simulator of 2013 had it
  double contact_time_s = 0.008;   // time constant of a contact, critically damped
  double step_s = 0.001;           // of the physics
};

/// Board's inertial sensor. Counts are made from this by the virtual board.
struct ImuSettings {
  // Saturation: 2000 deg/s and 4 g. The board's register ends before the gyroscope does, at 1835 deg/s.
  double gyro_range_rad_s = 34.907, accel_range_m_s2 = 39.24;
  std::array<double, 3> gyro_bias_rad_s{}, accel_bias_m_s2{};
  std::array<double, 3> gyro_scale{1, 1, 1}, accel_scale{1, 1, 1};  // -1 mirrors an axis
  double gyro_noise_rad_s = 0, accel_noise_m_s2 = 0;                // standard deviation per sample of 1 ms
};

struct Model {
  std::string name;    // "darwin-op"
  std::string folder;  // where the file was; `body.xml` is looked for there
  ServoParameters servo;
  std::vector<EffectSetting> effects;
  BodySettings body;
  ImuSettings imu;
};

/// Reads a model file. Throws std::runtime_error, "FILE, line N: what is wrong and what is allowed"; nothing is half
/// loaded.
Model readModel(const std::string& path);
Model parseModel(std::string_view text, const std::string& file);

/// `name`: a path to an INI file, or the name of a model that is shipped ("darwin-op", "webots-2013"). Throws
/// std::runtime_error that lists the shipped ones.
std::string findModel(const std::string& name);
/// Names of the models that are shipped.
std::vector<std::string> shippedModels();

/// The same model as text; parseModel() gives it back to the last bit.
std::string writeModel(const Model& model);

/// `text` of a model file with the section of `setting` added, or replaced where it already stands. Everything else,
/// comments too, stays as it is. `comments` go above the section, one line each, without their ';'.
std::string withEffect(std::string_view text, const EffectSetting& setting, const std::vector<std::string>& comments);
/// Without it. Throws std::runtime_error when there is none.
std::string withoutEffect(std::string_view text, std::string_view id, std::optional<Joint> joint);

/// The effects of one joint, in the order of the catalogue.
std::vector<std::unique_ptr<Effect>> effectsOf(const Model& model, Joint joint);

}  // namespace darwinop::twin
