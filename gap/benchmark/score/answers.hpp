// Results of a suite: results.json.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace darwinop::gap {

struct AnswerEffect {
  std::string id;
  std::map<std::string, double> values;
  std::map<std::string, std::pair<double, double>> intervals;  // 90 %, low and high; may be missing
};

struct AnswerPlace {
  std::string file;
  double from_s = 0, to_s = 0;
  std::string block;  // "controller"; empty: not stated
};

struct CaseAnswer {
  std::string verdict;  // "named"
  std::vector<AnswerEffect> effects;
  std::vector<std::vector<std::string>> ambiguity;
  std::vector<AnswerPlace> places;       // strongest first
  std::string block;                     // block in which it was found; empty: not stated
  std::string first_open_block;          // first open block before any fit; empty: not stated
  double before_rad = 0, after_rad = 0;  // on the held-out logs; NaN: not stated
  double runtime_s = 0;                  // NaN: not stated
};
using Answers = std::map<std::string, CaseAnswer>;  // by name of the case

/// Throws std::runtime_error, a sentence with file and case.
Answers readAnswers(const std::string& path);

}  // namespace darwinop::gap
