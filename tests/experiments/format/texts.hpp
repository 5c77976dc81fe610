// A small experiment as text, for tests that change one line of it.
#pragma once

#include <stdexcept>
#include <string>

#include "experiments/format/plan.hpp"
#include "experiments/format/reader.hpp"

namespace darwinop::experiments {

// Lines are counted from the first one.
inline const std::string kNod = R"([experiment]
name = nod
title = The head nods
[setup]
pose = start
duration = 1 s
[phase turn]
joints = Neck
goal = step
to = 30 deg
velocity = 2 rad/s
duration = 1 s
[record]
joints = Neck
)";

inline std::string with(std::string text, const std::string& line, const std::string& instead) {
  const std::size_t at = text.find(line);
  if (at == std::string::npos) throw std::logic_error("no such line: " + line);
  return text.replace(at, line.size(), instead);
}

/// What the phase of kNod does.
inline const std::string kStep = "goal = step\nto = 30 deg\nvelocity = 2 rad/s\n";

/// kNod with other lines for its phase.
inline Experiment phase(const std::string& lines) {
  return parseExperiment(with(kNod, kStep, lines), "my.ini");
}

/// The sentence with which `text` is refused, by the reader or by the plan; empty: it is not.
inline std::string refusal(const std::string& text) {
  try {
    const Experiment experiment = parseExperiment(text, "my.ini");
    makePlan(experiment, safety::hardRanges());
    return {};
  } catch (const std::runtime_error& refused) {
    return refused.what();
  }
}

}  // namespace darwinop::experiments
