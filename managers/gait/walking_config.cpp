// Reads gait parameters from an INI file, section [Walking Config].
#include "managers/gait/walking_config.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "core/text/ini_text.hpp"
#include "core/text/key_lines.hpp"
#include "core/text/letter_case.hpp"
#include "core/text/number_text.hpp"
#include "hal/text_file.hpp"

namespace darwinop::gait {

namespace {

// Value that means "absent" in files of 2013.
constexpr double kAbsent = -1024;

std::string rangeMessage(const ParameterRow& row, std::string_view key, std::string_view value) {
  return std::string{key} + " = " + std::string{value} + ": give a number from " + text::shortestText(row.low) +
         " to " + text::shortestText(row.high) + " (" + std::string{row.unit} + ")";
}

class WalkingConfigReader final : public text::IniReader {
 public:
  explicit WalkingConfigReader(const std::string& file) : file_{file} {}

  WalkingConfig read(std::string_view text) {
    text::readIni(text, file_, *this);
    return std::move(config_);
  }

 private:
  static bool ours(std::string_view section) { return text::lowered(section) == "walking config"; }

  void stray(std::string_view section, std::string_view, int line) override {
    if (ours(section)) warn(line, "is neither key = value nor a comment; it is ignored");
  }

  void pair(std::string_view section, std::string_view key, std::string_view value, int line) override {
    if (!ours(section)) return;
    if (const int first = keys_.firstOf(section, key, line); first > 0)
      return warn(line, "key \"" + std::string{key} + "\" is in line " + std::to_string(first) + ", which counts");
    const std::string name = text::lowered(key);
    if (name == "ik") return takeIk(value);
    const auto* const row = std::ranges::find(kParameters, name, &ParameterRow::name);
    if (row == kParameters.end())
      return warn(line, "key \"" + std::string{key} + "\" of section [Walking Config] is unknown; it is ignored");
    const std::optional<double> number = text::numberFromText(value);
    if (number && *number == kAbsent) return;
    if (!number || !(*number >= row->low && *number <= row->high))
      throw std::runtime_error(rangeMessage(*row, key, value));
    config_.parameters.*row->field = *number;
    if ((name == "i_gain" || name == "d_gain") && *number != 0)
      warn(line, "key \"" + name + "\" has no effect on this robot; only p_gain has");
  }

  void takeIk(std::string_view value) {
    const std::string choice = text::lowered(value);
    if (choice != "flawed" && choice != "exact")
      throw std::runtime_error("ik = " + std::string{value} + ": give flawed or exact");
    config_.parameters.ik = choice == "exact" ? Ik::kExact : Ik::kFlawed;
  }

  void warn(int line, const std::string& what) { config_.warnings.push_back(text::where(file_, line) + ": " + what); }

  const std::string& file_;
  text::KeyLines keys_;  // the first counts, as in 2013
  WalkingConfig config_;
};

}  // namespace

std::string findParameterError(const Parameters& parameters) {
  for (const ParameterRow& row : kParameters) {
    const double value = parameters.*row.field;
    if (!(value >= row.low && value <= row.high))  // also NaN
      return rangeMessage(row, row.name, text::shortestText(value));
  }
  return {};
}

WalkingConfig parseWalkingConfig(std::string_view text, const std::string& file) {
  return WalkingConfigReader{file}.read(text);
}

WalkingConfig readWalkingConfig(const std::string& path) {
  if (path.empty()) return {{}, {kNoConfigName}};
  const std::optional<std::string> text = readTextFile(path);
  if (!text) return {{}, {"cannot find " + path + ": the default gait parameters are used"}};
  return parseWalkingConfig(*text, path);
}

}  // namespace darwinop::gait
