// Reads a model file. Strict: a misspelled key or a missing parameter is an error, because it would bias a calibration.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>

#include "core/text/ini_text.hpp"
#include "core/text/letter_case.hpp"
#include "core/text/nearest.hpp"
#include "hal/text_file.hpp"
#include "twin/model/keys.hpp"
#include "twin/model/law_check.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/sections.hpp"
#include "twin/model/shipped.hpp"

namespace darwinop::twin {
namespace {

namespace fs = std::filesystem;

std::string duplicateOf(int line) {
  return " is already in line " + std::to_string(line) + "; keep one of the two";
}

class ModelReader final : public text::IniReader {
 public:
  explicit ModelReader(const std::string& file) : file_{file} {}

  Model read(std::string_view text) {
    text::readIni(text, file_, *this);
    for (const EffectSetting& effect : model_.effects) checkComplete(effect);
    for (const EffectSetting& effect : model_.effects) checkLaw(effect);
    if (model_.name.empty()) fail("model", "[model] name is missing; add one, as in name = my-robot");
    if (model_.body.contact_time_s < 2 * model_.body.step_s)
      fail(lines_.contains("body/contact_time") ? "body/contact_time" : "body/step",
           "[body] contact_time is shorter than two steps; give at least " +
               writeNumber(2 * model_.body.step_s, {.unit = "s"}) + ", or a smaller step");
    checkAxes("gyro_axes", model_.imu.gyro_axes);
    checkAxes("accel_axes", model_.imu.accel_axes);
    model_.file = file_;
    for (std::size_t link = 0; link < kLinks; ++link) {
      const std::string section{linkSection(link)};
      if (lines_.contains(section)) model_.link_lines[link] = lineOf(section);
      if (lines_.contains(section + "/mass")) model_.link_lines[link] = lineOf(section + "/mass");
    }
    return model_;
  }

  /// Line of a section or "section/key"; 1 if absent.
  [[nodiscard]] int lineOf(const std::string& what) const {
    const auto found = lines_.find(what);
    return found == lines_.end() ? 1 : found->second;
  }

  [[noreturn]] void fail(const std::string& what, const std::string& message) const {
    throw std::runtime_error(text::where(file_, lineOf(what)) + ": " + message);
  }

 private:
  void section(std::string_view name, int line) override {
    section_ = sectionFrom(name);
    const std::string written = text(section_);
    const auto [was, is_new] = lines_.emplace(written, line);
    if (!is_new) throw std::runtime_error("[" + written + "]" + duplicateOf(was->second));
    if (section_.info == nullptr) return;
    constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
    model_.effects.push_back(
        {section_.info, std::vector<double>(section_.info->parameters.size(), kMissing), section_.joint});
  }

  void stray(std::string_view, std::string_view text, int) override {
    throw std::runtime_error("\"" + std::string{text} + "\" is neither a [section], nor key = value, nor a comment");
  }

  void pair(std::string_view section, std::string_view key, std::string_view value, int line) override {
    if (section.empty() && lines_.empty())
      throw std::runtime_error("key \"" + std::string{key} +
                               "\" is before the first section; start the file with [model]");
    const std::string written = text(section_), low = text::lowered(key);
    if (const auto [was, is_new] = lines_.emplace(written + '/' + low, line); !is_new)
      throw std::runtime_error("[" + written + "] " + std::string{key} + duplicateOf(was->second));
    try {
      section_.info == nullptr ? takeKey(low, value) : takeParameter(low, value);
    } catch (const std::runtime_error& wrong) {
      throw std::runtime_error("[" + written + "] " + std::string{key} + " = " + std::string{value} + ": " +
                               wrong.what());
    }
  }

  void takeKey(const std::string& key, std::string_view value) {
    const KeyRow* const row = findKey(section_.plain, key);
    if (row == nullptr) throw std::runtime_error("no such key; " + text::suggestion(key, keysOf(section_.plain)));
    readValue(model_, *row, value);
  }

  void takeParameter(const std::string& key, std::string_view value) {
    const auto parameters = section_.info->parameters;
    const auto found = std::ranges::find(parameters, key, &Parameter::key);
    if (found == parameters.end())
      throw std::runtime_error("no such key; " + text::suggestion(key, parametersOf(*section_.info)));
    model_.effects.back().values[static_cast<std::size_t>(found - parameters.begin())] =
        readNumber(value, ruleOf(*found));
  }

  /// Parameters of effects have no defaults: a section states the effect completely.
  void checkComplete(const EffectSetting& effect) const {
    const std::string written = text({.info = effect.info, .joint = effect.joint});
    for (std::size_t i = 0; i < effect.values.size(); ++i) {
      if (!std::isnan(effect.values[i])) continue;
      const Parameter& missing = effect.info->parameters[i];
      fail(written, "[" + written + "] " + std::string{missing.key} + messages::kMissing + allowed(ruleOf(missing)));
    }
  }

  void checkLaw(const EffectSetting& effect) const {
    const Parameter* const idle = withoutEquation(model_, effect);
    if (idle == nullptr) return;
    const std::string written = text({.info = effect.info, .joint = effect.joint}), key{idle->key};
    fail(written + "/" + key, "[" + written + "] " + key + lawAdvice(*effect.info, *idle));
  }

  void checkAxes(const std::string& key, std::array<double, 3> axes) const {
    for (double& axis : axes) axis = std::abs(axis);
    std::ranges::sort(axes);
    if (axes != std::array<double, 3>{1, 2, 3})
      fail("imu/" + key, "[imu] " + key + " reads no three axes; give 1, 2 and 3 in any order, with or without minus");
  }

  const std::string& file_;
  Model model_;
  SectionName section_;
  std::map<std::string, int> lines_;  // of sections, and of "section/key"
};

}  // namespace

std::string whereLinkIs(const Model& model, std::size_t link) {
  std::string at = model.file.empty() ? "" : text::where(model.file, std::max(1, model.link_lines[link])) + ": ";
  return at + "[" + std::string{linkSection(link)} + "]";
}

Model parseModel(std::string_view text, const std::string& file) {
  Model model = ModelReader{file}.read(text);
  model.folder = bodyFolder(file, model.body.xml);
  return model;
}

Model readModel(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw std::runtime_error(path + messages::kIsFolder + "name a model file in it, such as " +
                             (fs::path{path} / "darwin-op.ini").string());
  const auto text = readTextFile(path);
  if (!text) throw std::runtime_error(messages::kNoModelFile + path + "; " + listShippedModels());
  ModelReader reader{path};
  Model model = reader.read(*text);
  model.folder = bodyFolder(path, model.body.xml);
  const fs::path xml = fs::path{model.folder} / model.body.xml;
  if (!isFile(xml))
    reader.fail("body/xml", "[body] xml = " + model.body.xml + ": " +
                                (fs::is_directory(xml, ignored) ? xml.string() + messages::kIsFolder
                                                                : messages::kNoBodyFile + xml.string() + "; ") +
                                "give a file in the folder of the model file, or darwin-op.xml");
  return model;
}

}  // namespace darwinop::twin
