// Commands of darwinop-gap.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gap/data/case.hpp"

namespace darwinop::gap {

struct Arguments {
  std::string folder;  // a case, or of cases
  std::string out;     // file or folder to write
  std::string model;   // model file or name, in place of the case's
  std::string report;  // folder; empty: named after the case
  bool no_report = false, open = false, no_open = false;
  std::string before, after;  // files of models to compare
  bool json = false;
  std::string target;                // of an export
  std::vector<std::string> effects;  // to hide: "coulomb", "coulomb:2" (severity) or "coulomb.friction=0.05"
  std::string baseline = "CV";
  std::string name = "hidden";  // of the case to make
  bool wrong_numbers = false;
  std::uint64_t seed = 1;
  std::string part = "quick";                 // part of the synthetic suite
  std::size_t cases = 0;                      // of the suite; 0: all
  std::size_t jobs = 1;                       // cases at once
  bool resume = false;                        // of a suite
  unsigned threads = 0;                       // 0: as many as there are cores
  std::string results, key;                   // to score
  std::string against;                        // to plan for: comma-separated effect ids; empty: from the verdict
  std::string joint = "ShoulderR";            // that swings the arm in planned experiments
  std::optional<double> hangs_at_rad;         // its angle where the arm hangs; nothing: as the robot's arms do
  std::string write;                          // folder for planned experiments
  std::vector<std::string> recordings, kept;  // to make a case of
  double at_least = 0;                        // required fair-answer rate
};

/// The case, with the given model in place of its own.
Case readGiven(const Arguments& given);
/// Warnings about the case, one per line.
void printWarnings(const Case& read);

// Each returns the exit code. Throws std::runtime_error.
int check(const Arguments& given);
int where(const Arguments& given);
int run(const Arguments& given);
int compareModels(const Arguments& given);
int addEffects(const Arguments& given);
int runBattery(const Arguments& given);
int hideEffects(const Arguments& given);
int writeBattery(const Arguments& given);
int scoreResults(const Arguments& given);
int writeFor(const Arguments& given);
int planNext(const Arguments& given);
int makeCase(const Arguments& given);

}  // namespace darwinop::gap
