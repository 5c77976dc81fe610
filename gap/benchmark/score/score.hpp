// Scores results against the answer key.
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/benchmark/make/answer_key.hpp"
#include "gap/benchmark/score/answers.hpp"

namespace darwinop::gap {

/// 95 % confidence interval of a share (Wilson 1927). `of` 0: 0 to 1.
std::pair<double, double> wilson(std::size_t right, std::size_t of);

inline constexpr double kNoTarget = std::numeric_limits<double>::quiet_NaN();

/// Of cases, or of parameters.
struct ShareFigure {
  std::string what;
  double at_least = kNoTarget, at_most = kNoTarget;
  std::size_t right = 0, of = 0;

  void count(bool is_right) {
    ++of;
    right += is_right ? 1 : 0;
  }
  [[nodiscard]] double share() const { return static_cast<double>(right) / static_cast<double>(of); }
  [[nodiscard]] bool reached() const;  // true of nothing
};

/// Of numbers: the median, and what 90 % (or all) are at most.
struct SpreadFigure {
  std::string what, unit;
  double median_at_most = kNoTarget, upper_at_most = kNoTarget;
  double upper_quantile = 0.9;
  std::vector<double> values = {};

  [[nodiscard]] double quantile(double share) const;  // NaN of nothing
  [[nodiscard]] bool reached() const;
};

/// Names of the figures, `what` of a ShareFigure or SpreadFigure.
namespace figures {
inline constexpr const char* kExactNumbers = "severity 2 and 3, exact numbers: named first";
inline constexpr const char* kWrongNumbers = "severity 2, numbers slightly wrong: named first";
inline constexpr const char* kWeak = "severity 1: named first";
inline constexpr const char* kHonest = "all of these, or in an ambiguity of 3 at most";
inline constexpr const char* kInterval = "90 % interval holds the truth";
inline constexpr const char* kFalseAlarm = "effect-free: false alarm";
inline constexpr const char* kBothOfTwo = "two effects: both and nothing else";
inline constexpr const char* kFirstOfTwo = "two effects: the first right";
inline constexpr const char* kOutsideUnknown = "outside the catalogue: unknown, right place";
inline constexpr const char* kOutsideNamed = "outside the catalogue: a wrong name";
inline constexpr const char* kBlock = "block of the loop right";
inline constexpr const char* kFirstOpenBlock = "first open block right, before any fit";
inline constexpr const char* kParameterError = "parameter error when named";
inline constexpr const char* kGapOverFloor = "held-out logs: gap after, over the floor";
inline constexpr const char* kGapOverBefore = "held-out logs: gap after over before";
inline constexpr const char* kRuntime = "time of a case";
}  // namespace figures

struct Confusion {
  CaseClass kind = CaseClass::kSingle;
  std::string truth, answered;
  std::vector<std::string> cases;
};

struct Score {
  std::size_t cases = 0;
  ShareFigure fair{"fair answers"};
  std::vector<ShareFigure> shares;
  std::vector<ShareFigure> details;  // by severity, and whether the baseline's numbers were exact
  std::vector<SpreadFigure> spreads;
  std::vector<Confusion> confusions;     // wrong answers, by class, most frequent first
  std::vector<std::string> unanswered;   // cases without answer, or with one that came after kTooLate
  std::vector<std::string> without_key;  // answers to cases that the key does not have
};

/// Even the upper end of the interval of fair answers is below this share: more is wrong than chance explains.
bool isBelow(const Score& score, double fair_share);

inline constexpr double kTooLate = 180;  // s; such an answer is none

Score scoreOf(const Keys& keys, const Answers& answers);

/// For a terminal of 100 columns.
std::string asText(const Score& score);
nlohmann::json asJson(const Score& score);

}  // namespace darwinop::gap
