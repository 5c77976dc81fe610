// Ranks experiments by expected information per minute of robot time.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/plan/prediction.hpp"
#include "gap/plan/safety_check.hpp"

namespace darwinop::gap {

enum class Aim : std::uint8_t {
  kSeparate,  // the hypotheses from each other
  kReveal,    // the hypotheses after the first from the first: would they show?
  kNarrow,    // the interval of one parameter of the only hypothesis
};

struct Question {
  Aim aim = Aim::kSeparate;
  std::vector<FittedHypothesis> hypotheses;
  std::size_t unknown = 0;  // kNarrow: its index
};

struct Separation {
  std::size_t a = 0, b = 0;  // indices of hypotheses
  double sigma = 0;
};

struct Ranked {
  Vetted vetted;
  std::vector<Separation> separations;
  double sigma_before = 0, sigma_after = 0;  // kNarrow: of the search variable
  double gain = 0;                           // expected difference of log likelihood, or log of the narrowing
  [[nodiscard]] double perMinute() const { return gain / (vetted.seconds / 60); }
};

struct Refusal {
  std::string name, why;
};

struct NextExperiments {
  Question question;
  ArmSetup stand;
  std::vector<Ranked> ranked;  // best first
  std::vector<Refusal> refused;
};

/// `given`: for its law, pendulum and hidden numbers; the hypotheses contain what its logs determine.
NextExperiments nextExperiments(const Case& given, const ArmSetup& stand, Question question,
                                const std::vector<ExperimentCandidate>& candidates, int noise_runs = kNoiseRuns);

/// The experiment for one pair of hypotheses.
struct Decision {
  const Ranked* by = nullptr;
  Separation pair;
};
/// Of kSeparate: for each pair the first ranked experiment that separates it as an effect would show, else the one that
/// separates it most; none for a pair that no experiment separates.
std::vector<Decision> decisionsOf(const NextExperiments& next);

/// "small_sines: separates backlash from deadband by 14 sigma in 20 s"
std::string sentenceOf(const Question& question, const Ranked& ranked);
std::string asText(const NextExperiments& next);
nlohmann::json asJson(const NextExperiments& next);

}  // namespace darwinop::gap
