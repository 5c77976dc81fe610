// Answer key: the effects hidden in each case. Stored beside the cases, read only for scoring.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace darwinop::gap {

struct KeyEffect {
  std::string id;
  int severity = 0;                      // 1 to 3; 0: none was given
  std::map<std::string, double> values;  // friction counts that of the baseline in
};

struct KeyPlace {
  std::string file;
  double from_s = 0, to_s = 0;
};

enum class CaseClass { kSingle, kEffectFree, kDouble, kOutside };

struct Key {
  CaseClass kind = CaseClass::kEffectFree;
  std::string family = "twin";
  bool exact = true;     // the numbers of the baseline are those of the bench
  std::string baseline;  // "V0", "CV", "W", "F"
  std::vector<KeyEffect> effects;
  std::map<std::string, double> number_factors;      // bench over baseline
  double gap_fit_rad = 0, gap_held_out_rad = 0;      // measured against the baseline, rms
  double noise_fit_rad = 0, noise_held_out_rad = 0;  // measured against the bench without noise, rms
  std::vector<KeyPlace> places;                      // places of an effect outside the catalogue; empty: not stated
};
using Keys = std::map<std::string, Key>;  // by name of the case

/// As in the example suites. Throws std::runtime_error, a sentence with the file.
void writeKeys(const Keys& keys, const std::string& path);
Keys readKeys(const std::string& path);

}  // namespace darwinop::gap
