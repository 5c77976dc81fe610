// What the commands of darwinop-gap do.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "gap/case/case.hpp"

namespace darwinop::gap {

inline constexpr const char* kUsualJoint = "ShoulderR";

struct Arguments {
  std::string folder;  // a case, or of cases
  std::string out;     // file or folder to write
  std::string model;   // file or name of a model, in place of the case's
  std::string report;  // folder; empty: one that is named after the case
  bool no_report = false, open = false, no_open = false;
  std::string before, after;  // files of models to compare
  bool json = false;
  std::string target;                // of an export
  std::vector<std::string> effects;  // to hide: "coulomb", "coulomb:2" (severity) or "coulomb.friction=0.05"
  std::string baseline = "CV";
  std::string name = "hidden";  // of the case to make
  bool wrong_numbers = false;
  std::uint64_t seed = 1;
  std::string part = "quick";          // of our own suite
  std::string family = "servo";        // of its cases
  std::size_t cases = 0;               // of it; 0: all
  std::size_t jobs = 1;                // cases at once
  bool resume = false;                 // of a suite
  unsigned threads = 0;                // 0: as many as there are cores
  std::string results, key;            // to score
  bool table = false;                  // of cases, in place of a score
  std::string against;                 // to plan for: ids of effects, with commas; empty: from the identification
  std::string joint;                   // that swings the arm; empty: kUsualJoint
  std::optional<double> hangs_at_rad;  // its angle where the arm hangs; nothing: as the robot's arms do
  std::string write;                   // folder for planned experiments
  std::vector<std::string> recordings, held_out;  // to make a case of
  std::string from_bam, from_csv, to_bam;         // folder of raw logs, or case to write as BAM logs
  std::vector<std::string> declared;              // of raw logs: "kp=32"
  bool all_logs = false;                          // raw logs: none is left to the comparison alone
  std::string robot;                              // to record: as DARWINOP_ROBOT
  bool yes = false, floor = false;                // of a recording
  std::string add, up;                            // one more experiment for a case; "0,-1,0", in the trunk's frame
  double at_least = 0;                            // minimum share of fair answers

  [[nodiscard]] std::string jointOrUsual() const { return joint.empty() ? kUsualJoint : joint; }
};

/// Arguments and data were right, and what was computed was not delivered: exit code 1.
struct NotDelivered : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Runs `work`, which begins when arguments and files have been read: what it throws is NotDelivered, except BadInput.
int deliver(const std::function<int()>& work);

/// A folder of raw logs without a case.json is made into a case in the folder `into`; notes go to stderr.
void makeRawCase(const Arguments& given, const std::string& raw, const std::string& into);
/// The case, with the model that stands in for its own.
Case readGiven(const Arguments& given);
/// What is odd about the case, or left out of it; a line each.
void printWarnings(const Case& read);

// Each returns the exit code, and throws std::runtime_error with a sentence.
int check(const Arguments& given);
int where(const Arguments& given);
int run(const Arguments& given);
int compareModels(const Arguments& given);
int addEffects(const Arguments& given);
int runBenchmark(const Arguments& given);
int hideEffects(const Arguments& given);
int makeBenchmark(const Arguments& given);
int scoreBenchmark(const Arguments& given);
int writeFor(const Arguments& given);
int planNext(const Arguments& given);
int makeCase(const Arguments& given);
// The same of a case of the whole robot, gap_body.cpp.
int checkBody(const Arguments& given);
int locateBody(const Arguments& given);
int runBody(const Arguments& given);
int addToBody(const Arguments& given);
int compareOnBody(const Arguments& given);
int writeBodyFor(const Arguments& given);
int planForBody(const Arguments& given);  // gap_plan.cpp
int recordBody(const Arguments& given);   // gap_record.cpp

}  // namespace darwinop::gap
