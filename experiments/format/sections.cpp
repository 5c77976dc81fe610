// Reads an experiment file into sections and entries; rejects unknown and duplicate names.
#include "experiments/format/sections.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/joints.hpp"
#include "core/text/ini_text.hpp"
#include "core/text/joined.hpp"
#include "core/text/number_text.hpp"
#include "experiments/format/messages.hpp"
#include "experiments/format/quantity.hpp"

namespace darwinop::experiments {
namespace {

using Words = std::vector<std::string_view>;

const Words kKinds{"experiment", "setup", "sweep", "phase", "record"};

Words keysOf(std::string_view kind) {
  if (kind == "experiment") return {"name", "title", "source", "description"};
  if (kind == "sweep") return {"values", "repeat"};
  if (kind == "record") return {"joints", "sensors"};
  if (kind == "phase")
    return {"joints",   "goal",     "to",           "amplitude", "period",       "frequency", "goals", "every",
            "duration", "velocity", "acceleration", "p_gain",    "torque_limit", "torque",    "until", "within"};
  Words keys{"pose", "duration", "settle", "trunk"};
  for (const JointRow& joint : kJointTable) keys.push_back(joint.name);
  return keys;
}

class SectionReader final : public text::IniReader {
 public:
  std::vector<Section> sections;

  void section(std::string_view text, int line) override {
    text = text::withoutBlanks(text);
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string kind{text.substr(0, blank)}, name{text::withoutBlanks(text.substr(blank))};
    if (std::ranges::find(kKinds, kind) == kKinds.end())
      throw std::runtime_error("there is no section [" + kind + "]" + didYouMean(kind, kKinds) +
                               "; allowed are [experiment], [setup], [sweep], [phase NAME], [record]");
    if ((kind == "phase") == name.empty())
      throw std::runtime_error(kind == "phase" ? std::string{messages::kPhaseNeedsName} + ": [phase raise]"
                                               : "[" + kind + "] takes no name");
    if (std::ranges::any_of(sections, [&](const Section& s) { return s.kind == kind && s.name == name; }))
      throw std::runtime_error("[" + std::string{text} + "] is defined twice; remove one");
    sections.push_back({kind, name, line, {}});
  }

  void pair(std::string_view, std::string_view key, std::string_view value, int line) override {
    if (sections.empty()) throw std::runtime_error("a line before the first section; start the file with [experiment]");
    Section& section = sections.back();
    const Words known = keysOf(section.kind);
    if (std::ranges::find(known, key) == known.end())
      throw std::runtime_error("[" + section.kind + "] has no key '" + std::string{key} + "'" + didYouMean(key, known) +
                               "; allowed are " + text::joined(known));
    if (section.find(key) != nullptr && key != "description")
      throw std::runtime_error("'" + std::string{key} + "' is set twice in this section; remove one");
    if (value.empty()) throw std::runtime_error("'" + std::string{key} + "' has no value");
    section.entries.push_back({std::string{key}, std::string{value}, line});
  }

  void stray(std::string_view, std::string_view text, int) override {
    throw std::runtime_error("'" + std::string{text} + "' " + messages::kNeitherSectionNorPair);
  }
};

}  // namespace

const Entry* Section::find(std::string_view key) const {
  const auto found = std::ranges::find(entries, key, &Entry::key);
  return found == entries.end() ? nullptr : &*found;
}

std::vector<Section> readSections(std::string_view text, const std::string& file) {
  SectionReader reader;
  text::readIni(text, file, reader);
  return std::move(reader.sections);
}

}  // namespace darwinop::experiments
