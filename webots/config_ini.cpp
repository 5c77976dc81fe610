// config.ini: what a controller says about itself and about the robot's limits.
#include "webots/config_ini.hpp"

#include <ini.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "webots/ini_lines.hpp"

namespace darwinop::facade {

namespace {

struct Size {
  int width, height;
};
// Source: what the robot's camera offers; the other sizes of the simulator do not exist on it.
constexpr auto kCameraSizes =
    std::to_array<Size>({{320, 240}, {640, 360}, {640, 400}, {640, 480}, {768, 480}, {800, 600}});

std::string lowered(std::string_view text) {
  std::string out{text};
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

/// The joint's own spelling: keys of an INI file may be written in any case.
std::string_view jointName(std::string_view key) {
  for (const JointRow& joint : kJointTable)
    if (lowered(joint.name) == lowered(key)) return joint.name;
  return key;
}

/// A key of [Safety] or [Limits]: where such a one is ignored, a limit does not limit.
bool isLimit(std::string_view key) {
  bool found = findJoint(jointName(key)).has_value();
  safety::Config{}.visit([&](std::string_view name, const auto&...) { found = found || name == lowered(key); });
  return found;
}

/// Safety's own sentences begin with the usual name of the file; ours have its path.
std::string_view withoutFile(std::string_view sentence) {
  constexpr std::string_view kFile = "config.ini, ";
  if (sentence.starts_with(kFile)) sentence.remove_prefix(kFile.size());
  return sentence;
}

/// A whole number from 1 to `high`; "16.0" counts as one, fractions are cut off as they always were.
int number(std::string_view key, std::string_view value, int high) {
  double parsed = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), parsed);
  if (error != std::errc{} || end != value.data() + value.size() || !(parsed >= 1 && parsed < high + 1.0))
    throw std::runtime_error(std::string{key} + " = " + std::string{value} + ": give a number from 1 to " +
                             std::to_string(high));
  return static_cast<int>(parsed);
}

/// One pass over one text. inih is C: nothing may be thrown through it, so the first error is kept.
class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : lines_{text}, file_{file} {}

  ConfigReading read() {
    ini_parse_stream(&Reader::nextLine, this, &Reader::takePair, this);
    if (lines_.cut() > 0) throw std::runtime_error(where(lines_.cut()) + ": the line is too long");
    if (!error_.empty()) throw std::runtime_error(error_);
    finish();
    return std::move(reading_);
  }

 private:
  static char* nextLine(char* into, int size, void* self) {
    auto* const reader = static_cast<Reader*>(self);
    char* const line = reader->lines_.next(into, size);
    if (line != nullptr) reader->look(line);
    return line;
  }

  /// Finds what inih passes over in silence.
  void look(std::string_view line) {
    if (line.starts_with('[')) {
      const auto end = line.find(']');
      if (end == line.npos) return fail("the section's closing bracket ] is missing");
      if (line.find_first_of("=:", end) != line.npos) return fail("put the key into a line of its own");
      room_ = lowered(line.substr(1, end - 1));
    } else if (!line.empty() && line.find_first_of("=:") == line.npos) {
      if (room_ == "safety" || room_ == "limits") return fail("\"" + std::string{line} + "\" is no key = value");
      warn(lines_.number(), "is no [section], no key = value and no comment; it is ignored");
    }
  }

  /// The first error counts.
  void fail(std::string_view what) {
    if (error_.empty()) error_ = where(lines_.number()) + ": " + std::string{withoutFile(what)};
  }

  static int takePair(void* self, const char* section, const char* key, const char* value) {
    static_cast<Reader*>(self)->take(section, key, withoutQuotes(value));
    return 1;
  }

  void take(std::string_view section, std::string_view key, std::string_view value) {
    if (!error_.empty()) return;
    try {
      place(section, key, value);
    } catch (const std::exception& wrong) {
      fail(wrong.what());
    }
  }

  void place(std::string_view section, std::string_view key, std::string_view value) {
    const std::string room = lowered(section);
    ControllerConfig& config = reading_.config;
    if (room == "safety") return config.safety.set("Safety", lowered(key), value);
    if (room == "limits") return config.safety.set("Limits", jointName(key), value);
    // Read by the gait, the camera and the servo offsets, each by itself.
    if (room == "walking config" || room == "camera" || room == "offset") return;
    if (room == "robot config") {
      const std::string name = lowered(key);
      if (name == "time_step") return keep(config.time_step_ms, has_time_step_, number(key, value, 10000));
      if (name == "camera_width") return keep(config.camera_width, has_width_, number(key, value, 4096));
      if (name == "camera_height") return keep(config.camera_height, has_height_, number(key, value, 4096));
    }
    if (isLimit(key))
      throw std::runtime_error("key \"" + std::string{key} + "\" stands in section [" + std::string{section} +
                               "], where it would limit nothing; it belongs into [Safety], names of joints into "
                               "[Limits]");
    warn(lines_.number(), "key \"" + std::string{key} + "\" of section [" + std::string{section} +
                              "] means nothing to this version; it is ignored");
  }

  static void keep(int& field, bool& has, int value) {
    field = value;
    has = true;
  }

  void finish() {
    ControllerConfig& config = reading_.config;
    // The first words are those that users know from the wrapper of 2013.
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
    try {
      config.safety.check();
    } catch (const std::exception& wrong) {
      throw std::runtime_error(file_ + ", " + std::string{withoutFile(wrong.what())});
    }
  }

  [[nodiscard]] std::string where(int line) const { return file_ + ", line " + std::to_string(line); }
  void warn(int line, const std::string& what) { reading_.warnings.push_back(where(line) + ": " + what); }

  IniLines lines_;
  const std::string& file_;
  ConfigReading reading_;
  std::string error_;
  std::string room_;  // section of the line at hand, in lower case
  bool has_time_step_ = false, has_width_ = false, has_height_ = false;
};

}  // namespace

ConfigReading parseConfig(std::string_view text, const std::string& file) {
  return Reader{text, file}.read();
}

bool cameraHasSize(int width, int height) {
  return std::ranges::any_of(kCameraSizes, [=](Size size) { return size.width == width && size.height == height; });
}

ConfigReading readConfig(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{std::fopen(path.c_str(), "rb"), &std::fclose};
  if (!file && errno == ENOENT)
    return {{}, {"there is no " + path + ": a time step of 16 ms and a camera of 320x240 are used"}};
  std::string text;
  std::array<char, 4096> part{};
  while (file) {
    const std::size_t size = std::fread(part.data(), 1, part.size(), file.get());
    text.append(part.data(), size);
    if (size == 0) break;
  }
  // The limits of this robot may stand in it: without them nothing may move.
  if (!file || std::ferror(file.get()))
    throw std::runtime_error("cannot read " + path + ": " + std::strerror(errno) +
                             "; make it a file that you may read (chmod a+r), or remove it to use the defaults");
  return parseConfig(text, path);
}

}  // namespace darwinop::facade
