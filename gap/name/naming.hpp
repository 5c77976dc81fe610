// Names what is missing: effects one after the other, each against its rivals, until the rest is noise or nobody's.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gap/name/settled.hpp"

namespace darwinop::gap {

enum class Verdict { kNone, kNamed, kAmbiguous, kUnknown, kCannotTell, kBadInput };
std::string_view nameOf(Verdict verdict);
/// Of the command: 0 none, 10 named, 11 ambiguous, 12 unknown, 13 cannot_tell, 2 bad_input.
int exitCodeOf(Verdict verdict);

struct Estimate {
  std::string name;  // "coulomb.friction"
  std::string unit;
  double value = 0, low = 0, high = 0;  // the interval holds the truth in nine of ten cases
  bool seen = true;                     // false: the data say nothing about it, and any value of its range will do
};

struct Found {
  const twin::EffectInfo* effect = nullptr;
  std::vector<Estimate> estimates;
  double gain = 0;         // cost that it takes away, the others being there
  bool corrected = false;  // the baseline had it, with other numbers
};

/// A number of the baseline that the data pull out of its prior.
struct Strained {
  std::string number;
  double sigmas = 0, factor = 1;
};

/// Evidence, twice its logarithm: closer than that, the data do not decide. Odds of 150 to 1, where both were as likely
/// before; of 7 to 1 against who needs more numbers to explain no better.
inline constexpr double kRivalry = 10, kLargerRivalry = 4;

struct Rival {
  std::vector<std::string> effects;  // ids, instead of the named ones
  double behind = 0;                 // in evidence, twice its logarithm
  bool larger = false;               // has more numbers that are free

  [[nodiscard]] bool isClose() const { return behind < (larger ? kLargerRivalry : kRivalry); }
};

/// Why an effect that fits these logs better all the same is not named: the measured voltage says no; it foretells some
/// logs and others not; it foretells none; the kept logs are worse with it.
enum class Doubt : std::uint8_t { kVoltage, kUndecided, kForetellsNothing, kWorsensKept };
struct Doubted {
  const twin::EffectInfo* effect = nullptr;
  Doubt why = Doubt::kForetellsNothing;
};

struct Naming {
  Verdict verdict = Verdict::kNone;
  std::vector<Found> found;   // strongest first; for `ambiguous` in the order found, the last one contested
  std::vector<Rival> rivals;  // nearest first
  std::vector<Strained> strained;
  std::vector<Doubted> doubted;
  // Gain that chance exceeds once in a hundred cases; where the model is plainly wrong, in forty. NaN: not measured.
  double threshold = 0;
  double misfit = 0;  // of the final model, in standard deviations of what a right model shows
  double gap_before_rad = 0, gap_after_rad = 0;  // rms position error over the fit logs, closed loop
  double floor_rad = 0;                          // the same of a right model
  Hypothesis model;                              // with what was found
  bool remains = false;                          // named, and something is left that none of the effects explains
};

struct NameOptions {
  int most_effects = 4;
  double alpha = 0.01;
  std::function<void(const std::string&)> tell = [](const std::string&) {};  // what it is doing, in a few words
};

Naming nameEffects(const Case& given, const NameOptions& options = {});

}  // namespace darwinop::gap
