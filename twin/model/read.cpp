// Reads a model file: strict, because a typing error in a model looks like a discovery about the robot.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>

#include "core/text/ini_text.hpp"
#include "core/text/letter_case.hpp"
#include "hal/text_file.hpp"
#include "twin/model/keys.hpp"
#include "twin/model/nearest.hpp"
#include "twin/model/sections.hpp"
#include "twin/model/shelf.hpp"

namespace darwinop::twin {
namespace {

namespace fs = std::filesystem;

std::string first(int line) {
  return " is there a second time, the first is in line " + std::to_string(line) + "; keep one of the two";
}

class Reader final : public text::IniReader {
 public:
  explicit Reader(const std::string& file) : file_{file} {}

  Model take(std::string_view text) {
    text::readIni(text, file_, *this);
    for (const EffectSetting& effect : model_.effects) checkComplete(effect);
    if (model_.name.empty()) fail("model", "[model] name is missing; say what the model is called: name = my-robot");
    if (model_.body.contact_time_s < 2 * model_.body.step_s)
      fail(lines_.contains("body/contact_time") ? "body/contact_time" : "body/step",
           "[body] contact_time is less than two steps; give at least " +
               writeNumber(2 * model_.body.step_s, {.unit = "s"}) + ", or a smaller step");
    return model_;
  }

  /// Of a section or "section/key", and of what is not there the first.
  [[nodiscard]] int lineOf(const std::string& what) const {
    const auto found = lines_.find(what);
    return found == lines_.end() ? 1 : found->second;
  }

  [[noreturn]] void fail(const std::string& what, const std::string& sentence) const {
    throw std::runtime_error(text::where(file_, lineOf(what)) + ": " + sentence);
  }

 private:
  void section(std::string_view name, int line) override {
    section_ = sectionFrom(name);
    const std::string written = text(section_);
    const auto [was, is_new] = lines_.emplace(written, line);
    if (!is_new) throw std::runtime_error("[" + written + "]" + first(was->second));
    if (section_.info == nullptr) return;
    constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
    model_.effects.push_back(
        {section_.info, std::vector<double>(section_.info->parameters.size(), kMissing), section_.joint});
  }

  void stray(std::string_view, std::string_view text, int) override {
    throw std::runtime_error("\"" + std::string{text} + "\" is no [section], no key = value and no comment");
  }

  void pair(std::string_view section, std::string_view key, std::string_view value, int line) override {
    if (section.empty() && lines_.empty())
      throw std::runtime_error("key \"" + std::string{key} + "\" stands before the first section; begin with [model]");
    const std::string written = text(section_), low = text::lowered(key);
    if (const auto [was, is_new] = lines_.emplace(written + '/' + low, line); !is_new)
      throw std::runtime_error("[" + written + "] " + std::string{key} + first(was->second));
    try {
      section_.info == nullptr ? takeKey(low, value) : takeParameter(low, value);
    } catch (const std::runtime_error& wrong) {
      throw std::runtime_error("[" + written + "] " + std::string{key} + " = " + std::string{value} + ": " +
                               wrong.what());
    }
  }

  void takeKey(const std::string& key, std::string_view value) {
    const KeyRow* const row = findKey(section_.plain, key);
    if (row == nullptr) throw std::runtime_error("no such key; " + suggestion(key, keysOf(section_.plain)));
    readValue(model_, *row, value);
  }

  void takeParameter(const std::string& key, std::string_view value) {
    const auto parameters = section_.info->parameters;
    const auto found = std::ranges::find(parameters, key, &Parameter::key);
    if (found == parameters.end())
      throw std::runtime_error("no such key; " + suggestion(key, parametersOf(*section_.info)));
    model_.effects.back().values[static_cast<std::size_t>(found - parameters.begin())] =
        readNumber(value, ruleOf(*found));
  }

  /// No parameter of an effect has a default: what an effect does is all said where it is switched on.
  void checkComplete(const EffectSetting& effect) const {
    const std::string written = text({.info = effect.info, .joint = effect.joint});
    for (std::size_t i = 0; i < effect.values.size(); ++i) {
      if (!std::isnan(effect.values[i])) continue;
      const Parameter& missing = effect.info->parameters[i];
      fail(written, "[" + written + "] " + std::string{missing.key} + " is missing; give " + allowed(ruleOf(missing)));
    }
  }

  const std::string& file_;
  Model model_;
  SectionName section_;
  std::map<std::string, int> lines_;  // of sections, and of "section/key"
};

/// Beside the model file, or among the shipped ones, so that a copy of a shipped model works anywhere.
std::string folderOf(const std::string& file, const std::string& xml) {
  std::string own = fs::path{file}.parent_path().string();
  std::vector<std::string> folders{own};
  for (const std::string& shelf : modelFolders()) folders.push_back(shelf);
  for (const std::string& folder : folders)
    if (isFile(fs::path{folder} / xml)) return folder;
  return own;
}

}  // namespace

Model parseModel(std::string_view text, const std::string& file) {
  Model model = Reader{file}.take(text);
  model.folder = folderOf(file, model.body.xml);
  return model;
}

Model readModel(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw std::runtime_error(path + " is a folder; name a model file in it, such as " +
                             (fs::path{path} / "darwin-op.ini").string());
  const auto text = readTextFile(path);
  if (!text) throw std::runtime_error("there is no model file " + path + "; " + shippedOnes());
  Reader reader{path};
  Model model = reader.take(*text);
  model.folder = folderOf(path, model.body.xml);
  const fs::path xml = fs::path{model.folder} / model.body.xml;
  if (!isFile(xml))
    reader.fail("body/xml", "[body] xml = " + model.body.xml + ": " +
                                (fs::is_directory(xml, ignored) ? xml.string() + " is a folder"
                                                                : "there is no file " + xml.string()) +
                                "; give a file that lies beside the model file, or darwin-op.xml");
  return model;
}

}  // namespace darwinop::twin
