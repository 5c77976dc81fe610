// Answers to cases of the whole robot: results.json of a run.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gap/benchmark/body/body_key.hpp"

namespace darwinop::gap {

/// An effect and its place.
struct PlacedName {
  std::string id;
  std::vector<std::string> at;
};

struct BodyAnswer {
  std::string verdict;
  std::vector<BodyKeyEffect> effects;
  std::vector<std::vector<PlacedName>> ambiguity;
  std::vector<std::string> where;                          // signals, most significant first
  double before_mrad = 0, after_mrad = 0, floor_mrad = 0;  // joints on held-out logs; NaN: not stated
  double runtime_s = 0;                                    // NaN: not stated
};
using BodyAnswers = std::map<std::string, BodyAnswer>;  // by name of the case

inline constexpr double kBodyTooLate = 300;  // s; such an answer is none
/// The answer to this case if it counts: in time, and no failure of the program. Else null.
const BodyAnswer* countedAnswer(const BodyAnswers& answers, const std::string& name);

/// Throws std::runtime_error, a sentence with file and case.
BodyAnswers readBodyAnswers(const std::string& path);

}  // namespace darwinop::gap
