// Parses an experiment file.
#include "experiments/format/reader.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/text/ini_text.hpp"
#include "core/text/joined.hpp"
#include "core/text/number_text.hpp"
#include "experiments/format/messages.hpp"
#include "experiments/format/phase_reader.hpp"
#include "experiments/format/quantity.hpp"
#include "experiments/format/sections.hpp"
#include "hal/text_file.hpp"

namespace darwinop::experiments {
namespace {

constexpr std::size_t kMaxPhases = 1000;  // including sweep and repeats

class FileReader {
 public:
  FileReader(std::string_view text, const std::string& file) : file_{file}, sections_{readSections(text, file)} {}

  Experiment read() {
    out_.file = file_;
    readHead();
    readSetup();
    readRounds();
    readRecord();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw std::runtime_error(text::where(file_, line) + ": " + message);
  }

  [[nodiscard]] const Section* find(std::string_view kind) const {
    const auto found = std::ranges::find(sections_, kind, &Section::kind);
    return found == sections_.end() ? nullptr : &*found;
  }
  [[nodiscard]] const Section& need(std::string_view kind) const {
    const Section* const section = find(kind);
    if (!section) throw std::runtime_error(file_ + ": the section [" + std::string{kind} + "] is missing");
    return *section;
  }
  [[nodiscard]] const Entry& need(const Section& section, std::string_view key) const {
    const Entry* const entry = section.find(key);
    if (!entry) fail(section.line, "[" + section.kind + "] needs '" + std::string{key} + "'");
    return *entry;
  }

  template <class Read>
  auto at(const Entry& entry, const Read& read) const {
    try {
      return read(std::string_view{entry.value});
    } catch (const std::runtime_error& wrong) {
      fail(entry.line, wrong.what());
    }
  }

  void readHead() {
    const Section& head = need("experiment");
    const Entry& name = need(head, "name");
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789_-";
    if (name.value.find_first_not_of(kLetters) != std::string::npos)
      fail(name.line, std::string{"the name is used in file names: "} + messages::kNameLetters);
    out_.name = name.value;
    out_.title = need(head, "title").value;
    if (const Entry* source = head.find("source")) out_.source = source->value;
    for (const Entry& entry : head.entries)
      if (entry.key == "description") out_.description.push_back(entry.value);
  }

  void readSetup() {
    const Section& section = need("setup");
    ExperimentSetup& setup = out_.setup;
    setup.line = section.line;
    const Entry& pose = need(section, "pose");
    std::vector<std::string_view> names;
    for (const NamedPose& known : namedPoses()) {
      names.push_back(known.name);
      if (known.name == pose.value) setup.named = &known;
    }
    if (!setup.named)
      fail(pose.line, "there is no pose '" + pose.value + "'" + didYouMean(pose.value, names) + "; poses are " +
                          text::joined(names));
    setup.pose = setup.named->pose;
    for (const Entry& entry : section.entries)
      if (const auto joint = findJoint(entry.key)) {
        setup.pose[index(*joint)] = at(entry, [](std::string_view text) { return parseNumber(text, kAngle); });
        setup.line_of[index(*joint)] = entry.line;
      }
    const auto time = [](std::string_view text) { return parseNumber(text, kDuration); };
    setup.duration_s = at(need(section, "duration"), time);
    if (const Entry* settle = section.find("settle")) setup.settle_s = at(*settle, time);
    if (const Entry* trunk = section.find("trunk")) {
      if (trunk->value != "free" && trunk->value != "clamped")
        fail(trunk->line, "'" + trunk->value + "' is not a way to hold the trunk; it is free or clamped");
      setup.is_clamped = trunk->value == "clamped";
    }
  }

  [[nodiscard]] std::string label(const std::string& value) const {
    std::string keys;
    for (const Section& section : sections_)
      for (const Entry& entry : section.entries)
        if (section.kind == "phase" && entry.value == "sweep" && keys.find(entry.key) == std::string::npos)
          keys += (keys.empty() ? "" : ", ") + entry.key;
    return keys + " = " + value;
  }

  void readRounds() {
    const Section* const sweep = find("sweep");
    std::vector<std::string> values{""};
    const Entry* const entry = sweep ? sweep->find("values") : nullptr;
    if (entry) {
      values.clear();
      for (const std::string_view value : splitList(entry->value)) values.emplace_back(value);
      if (label("").starts_with(' '))
        fail(entry->line, std::string{messages::kSweepUnused} + ": write KEY = sweep in one");
      if (std::ranges::find(values, "") != values.end()) fail(entry->line, "a value is missing between two commas");
    }
    const int repeat = readRepeat(sweep);
    for (const std::string& value : values)
      for (int i = 0; i < repeat; ++i) addRound(value, repeat == 1 ? "" : std::to_string(i + 1));
    if (out_.rounds.front().phases.empty()) throw std::runtime_error(file_ + ": no phase: add a section [phase NAME]");
  }

  [[nodiscard]] int readRepeat(const Section* sweep) const {
    const Entry* const entry = sweep ? sweep->find("repeat") : nullptr;
    if (!entry) return 1;
    const double number = text::numberFromText(entry->value).value_or(0);
    if (number < 1 || number > 100 || number != static_cast<int>(number))
      fail(entry->line, "'" + entry->value + "' is not a valid number of repeats: write an integer from 1 to 100");
    return static_cast<int>(number);
  }

  void addRound(const std::string& value, const std::string& number) {
    Round round;
    if (!value.empty()) round.label = label(value);
    if (!number.empty()) round.label += (value.empty() ? "turn " : ", turn ") + number;
    for (const Section& section : sections_) {
      if (section.kind != "phase") continue;
      round.phases.push_back(readPhase(section, value, file_));
      if (++phases_ > kMaxPhases) fail(section.line, "more than 1000 phases, including sweep and repeats");
    }
    out_.rounds.push_back(std::move(round));
  }

  void readRecord() {
    const Section& section = need("record");
    at(need(section, "joints"), [&](std::string_view text) {
      for (std::size_t i = 0; i < kJoints && text == kAllJoints; ++i)
        out_.record_joints.push_back(static_cast<Joint>(i));
      if (text == kAllJoints) return 0;
      for (const std::string_view name : splitList(text)) out_.record_joints.push_back(jointNamed(name));
      return 0;
    });
    const Entry* const sensors = section.find("sensors");
    if (!sensors) return;
    for (const std::string_view name : splitList(sensors->value)) {
      if (name != "gyro" && name != "accelerometer")
        fail(sensors->line, "there is no sensor '" + std::string{name} + "'; sensors are gyro, accelerometer");
      out_.record_sensors.emplace_back(name);
    }
  }

  const std::string& file_;
  std::vector<Section> sections_;
  std::size_t phases_ = 0;
  Experiment out_;
};

}  // namespace

Experiment parseExperiment(std::string_view text, const std::string& file) {
  return FileReader{text, file}.read();
}

Experiment readExperiment(const std::string& path) {
  const auto text = readTextFile(path);
  if (!text) throw std::runtime_error("there is no experiment file " + path);
  return parseExperiment(*text, path);
}

}  // namespace darwinop::experiments
