// The verdict in words.
#pragma once

#include <string>
#include <vector>

#include "gap/report/outcome.hpp"

namespace darwinop::gap {

/// Two sentences for a student: what is the matter, and what it does to logs that no fit has seen.
std::vector<std::string> verdictSentences(const Outcome& outcome, const Comparison& comparison);
/// The second one alone.
std::string helpSentence(const Comparison& comparison);

/// Why an effect is not named though it fits: in a line of a terminal, and in full.
std::string shortDoubt(const Doubted& doubted);
std::string doubtSentence(const Doubted& doubted);

/// Rivals that the data do not decide against.
std::vector<Rival> closeRivals(const Naming& naming);

/// What a table's flag means, where a log has one.
extern const std::string_view kBelowFloorSentence;

std::string joined(const std::vector<std::string>& words, std::string_view between);
/// "31.0", "0.931": three digits of a position error, mrad.
std::string inMrad(double rad);
/// As results.json has it: three digits behind the point; NaN stays.
double mradOf(double rad);

}  // namespace darwinop::gap
