// Parses config.ini.
#include "webots/config_ini.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/camera_sizes.hpp"
#include "core/conversions.hpp"
#include "core/text/ini_text.hpp"
#include "core/text/key_lines.hpp"
#include "core/text/letter_case.hpp"
#include "core/text/number_text.hpp"
#include "hal/text_file.hpp"
#include "safety/sections.hpp"
#include "webots/messages.hpp"

namespace darwinop::webots_api {

namespace {

/// An integer from 1 to `high`. For compatibility "16.0" is accepted and fractions are truncated.
int number(std::string_view key, std::string_view value, int high) {
  const std::optional<double> parsed = text::numberFromText(value);
  if (!parsed || !(*parsed >= 1 && *parsed < high + 1.0))
    throw std::runtime_error(std::string{key} + " = " + std::string{value} + ": give a number from 1 to " +
                             std::to_string(high));
  return static_cast<int>(*parsed);
}

class Reader final : public text::IniReader {
 public:
  explicit Reader(const std::string& file) : file_{file} {}

  ConfigReading read(std::string_view text) {
    text::readIni(text, file_, *this);
    finish();
    return std::move(reading_);
  }

 private:
  void stray(std::string_view section, std::string_view text, int line) override {
    const std::string room = text::lowered(section);
    if (room == "safety" || room == "limits")
      throw std::runtime_error("\"" + std::string{text} + "\" is not key = value");
    warn(line, "is no [section], no key = value and no comment; it is ignored");
  }

  void pair(std::string_view section, std::string_view key, std::string_view value, int line) override {
    const std::string room = text::lowered(section);
    ControllerConfig& config = reading_.config;
    if (room == "walking config") return;  // read by the gait
    if (const int first = keys_.firstOf(section, key, line); first > 0)
      return warn(line, "key \"" + std::string{key} + "\" is in line " + std::to_string(first) + ", which counts");
    if (safety::takeSafety(config.safety, section, key, value)) return;
    if (room == "camera") return takeCamera(config.camera, key, value, line);
    if (room == "offset") return reportOffset(key, value, line);
    if (room == "robot config") {
      const std::string name = text::lowered(key);
      if (name == "time_step") return keep(config.time_step_ms, has_time_step_, number(key, value, 10000));
      if (name == "camera_width") return keep(config.camera_width, has_width_, number(key, value, 4096));
      if (name == "camera_height") return keep(config.camera_height, has_height_, number(key, value, 4096));
    }
    if (safety::isLimit(key))
      throw std::runtime_error("key \"" + std::string{key} + "\" stands in section [" + std::string{section} +
                               "], where it would limit nothing; it belongs into [Safety], names of joints into "
                               "[Limits]");
    warn(line, "key \"" + std::string{key} + "\" of section [" + std::string{section} +
                   "] means nothing to this version; it is ignored");
  }

  void takeCamera(v4l2::CameraSettings& camera, std::string_view key, std::string_view value, int line) {
    struct Control {
      std::string_view name;
      int v4l2::CameraSettings::*field;
      int high;
    };
    static constexpr auto kControls = std::to_array<Control>({{"brightness", &v4l2::CameraSettings::brightness, 255},
                                                              {"contrast", &v4l2::CameraSettings::contrast, 255},
                                                              {"saturation", &v4l2::CameraSettings::saturation, 255},
                                                              {"gain", &v4l2::CameraSettings::gain, 255},
                                                              {"exposure", &v4l2::CameraSettings::exposure, 10000}});
    struct Switch {
      std::string_view name;
      bool v4l2::CameraSettings::*field;
    };
    static constexpr auto kSwitches =
        std::to_array<Switch>({{"auto_exposure", &v4l2::CameraSettings::auto_exposure},
                               {"auto_white_balance", &v4l2::CameraSettings::auto_white_balance},
                               {"auto_gain", &v4l2::CameraSettings::auto_gain},
                               {"auto_hue", &v4l2::CameraSettings::auto_hue}});
    if (const auto* const found = std::ranges::find(kSwitches, text::lowered(key), &Switch::name);
        found != kSwitches.end()) {
      const std::string said = text::lowered(value);
      if (said != "on" && said != "off")
        throw std::runtime_error(std::string{key} + " = " + std::string{value} + ": give on or off");
      camera.*found->field = said == "on";
      return;
    }
    const auto* const control = std::ranges::find(kControls, text::lowered(key), &Control::name);
    if (control == kControls.end())
      return warn(
          line,
          "key \"" + std::string{key} + "\" of section [Camera] means nothing to this version; there are " +
              "Brightness, Contrast, Saturation, Gain, Exposure, Auto_exposure, Auto_white_balance, Auto_gain and "
              "Auto_hue");
    const std::optional<double> parsed = text::numberFromText(value);
    // In files of 2013, -2 means that the key is missing.
    if (parsed && *parsed == -2) return;
    if (!parsed || !(*parsed >= v4l2::CameraSettings::kDriversDefault && *parsed < control->high + 1.0))
      throw std::runtime_error(std::string{key} + " = " + std::string{value} + ": give a number from 0 to " +
                               std::to_string(control->high) + ", or -1 for the driver's own");
    camera.*control->field = static_cast<int>(*parsed);
  }

  /// The robot of 2013 added these ticks to each goal.
  void reportOffset(std::string_view key, std::string_view value, int line) {
    const std::optional<double> ticks = text::numberFromText(value);
    if (!ticks || *ticks == 0) return;
    std::string entry = "an angle in rad";
    for (const JointRow& joint : kJointTable)
      if (text::lowered(key) == (joint.id < 10 ? "id_0" : "id_") + std::to_string(joint.id))
        entry = std::string{joint.name} + " = " + text::shortestText(std::round(*ticks * kRadPerTick * 1e4) / 1e4);
    warn(line, "[Offset] " + std::string{key} + " = " + std::string{value} + messages::kOffsetsAreTheRobots + entry);
  }

  static void keep(int& field, bool& has, int value) {
    field = value;
    has = true;
  }

  void finish() {
    ControllerConfig& config = reading_.config;
    // Starts with the message of the wrapper of 2013, which users know.
    if (!has_time_step_) reading_.warnings.push_back("Can't read time step from '" + file_ + "': 16 ms is used");
    if (!has_width_ || !has_height_)
      reading_.warnings.push_back("Can't read camera size from '" + file_ + "': 320x240 is used");
    const bool known = cameraHasSize(config.camera_width, config.camera_height);
    if (has_width_ && has_height_ && !known)
      reading_.warnings.push_back(file_ + ": a camera of " + std::to_string(config.camera_width) + "x" +
                                  std::to_string(config.camera_height) +
                                  " does not exist; 320x240 is used (also possible: 640x360, 640x400, 640x480, "
                                  "768x480, 800x600)");
    if (!has_width_ || !has_height_ || !known) config.camera_width = 320, config.camera_height = 240;
    safety::checkSafety(config.safety, file_);
  }

  void warn(int line, const std::string& what) { reading_.warnings.push_back(text::where(file_, line) + ": " + what); }

  const std::string& file_;
  text::KeyLines keys_;  // the first counts, as in 2013
  ConfigReading reading_;
  bool has_time_step_ = false, has_width_ = false, has_height_ = false;
};

}  // namespace

ConfigReading parseConfig(std::string_view text, const std::string& file) {
  return Reader{file}.read(text);
}

bool cameraHasSize(int width, int height) {
  return cameraSize(width, height) != nullptr;  // the other sizes of the simulator do not exist on the robot
}

ConfigReading readConfig(const std::string& path) {
  const std::optional<std::string> text = readTextFile(path);
  if (!text) return {{}, {"there is no " + path + ": a time step of 16 ms and a camera of 320x240 are used"}};
  return parseConfig(*text, path);
}

}  // namespace darwinop::webots_api
