// Model of a twin: all parameters that a calibration may change, read from one INI file. The body geometry is in the
// MuJoCo file that it names. Format: docs/twin/models.md.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/joints.hpp"
#include "twin/model/link.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

/// An enabled effect, for all servos or for one.
struct EffectSetting {
  const EffectInfo* info = nullptr;
  std::vector<double> values;  // one per parameter of info
  std::optional<Joint> joint;  // empty: all joints; a setting of one joint overrides it
};

/// Which of the contradicting sources for the trunk is used; docs/twin/body.md.
enum class TrunkCom { kManufacturer, kWebots2013, kHalfway };
enum class TrunkInertia { kBox, kPublished };

struct BodySettings {
  std::string xml = "darwin-op.xml";  // in the folder of the INI file or a model folder
  TrunkCom trunk_com = TrunkCom::kHalfway;
  TrunkInertia trunk_inertia = TrunkInertia::kBox;
  bool self_collision = false;
  bool hold_until_driven = false;  // a joint keeps its angle until its torque is first enabled
  double floor_friction = 1.0;     // Coulomb coefficient; value of the 2013 simulator
  double contact_time_s = 0.008;   // time constant of a contact, critically damped
  double sole_size = 1;            // factor on length and width of both soles
  // Slope of the floor: turned about the world's x (forward), then about y (left). A stand stays level.
  double floor_tilt_x_rad = 0, floor_tilt_y_rad = 0;
  double battery_resistance_ohm = 0;  // of battery and cables that all servos share
  double step_s = 0.001;              // physics time step
};

/// Inertial sensor of the board, in SI units; the virtual board converts to counts.
struct ImuSettings {
  // Saturation: 2000 deg/s and 4 g. The board's gyroscope register saturates earlier, at 1835 deg/s.
  double gyro_range_rad_s = 34.907, accel_range_m_s2 = 39.24;
  std::array<double, 3> gyro_bias_rad_s{}, accel_bias_m_s2{};
  std::array<double, 3> gyro_scale{1, 1, 1}, accel_scale{1, 1, 1};  // -1 mirrors an axis
  std::array<double, 3> mounting_rad{};                             // rotation vector of the board in the trunk's frame
  std::array<double, 3> gyro_axes{1, 2, 3}, accel_axes{1, 2, 3};    // true axis that is read as x, y, z, with its sign
  double gyro_lowpass_s = 0;                                        // time constant, first order; 0: no filter
  double delay_s = 0;                                               // of both sensors
  double gyro_noise_rad_s = 0, accel_noise_m_s2 = 0;                // standard deviation per sample of 1 ms
};

struct Model {
  std::string name;    // "darwin-op"
  std::string folder;  // that contains `body.xml`
  std::string file;    // for messages; empty: not read from a file
  ServoParameters servo;
  std::vector<EffectSetting> effects;
  BodySettings body;
  ImuSettings imu;
  std::array<LinkSettings, kLinks> links{};
  std::array<int, kLinks> link_lines{};  // of `file`, for messages; 0: unknown
};

/// Reads a model file. Throws std::runtime_error, "FILE, line N: problem; allowed values".
Model readModel(const std::string& path);
Model parseModel(std::string_view text, const std::string& file);

/// "FILE, line N: [link ArmLowerR]", for a message about a link.
std::string whereLinkIs(const Model& model, std::size_t link);

/// `name`: path of an INI file, or name of a shipped model ("darwin-op", "webots-2013"). Throws std::runtime_error with
/// the list of shipped models.
std::string findModel(const std::string& name);
std::vector<std::string> shippedModels();

/// The model as text; parseModel() of it returns the same model, bit for bit.
std::string writeModel(const Model& model);

/// Returns `text` of a model file with the section of `setting` added, or replaced in place. All other bytes, including
/// comments, are unchanged. `comments` go above the section, one line each, without ';'.
std::string withEffect(std::string_view text, const EffectSetting& setting, const std::vector<std::string>& comments);
/// Returns `text` without that section. Throws std::runtime_error if there is none.
std::string withoutEffect(std::string_view text, std::string_view id, std::optional<Joint> joint);

/// The effects of one joint, in the order of the catalogue.
std::vector<std::unique_ptr<Effect>> effectsOf(const Model& model, Joint joint);

}  // namespace darwinop::twin
