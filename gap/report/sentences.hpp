// The verdict in words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/report/results.hpp"

namespace darwinop::gap {

/// Two sentences for the user: the finding, and the error on the held-out logs.
std::vector<std::string> verdictSentences(const Outcome& outcome, const Comparison& comparison);
/// The second one alone.
std::string helpSentence(const Comparison& comparison);

/// Why an effect is not named though it fits: in a line of a terminal, and in full.
std::string shortRejection(const RejectedEffect& rejected);
std::string rejectionSentence(const RejectedEffect& rejected);

/// What a remainder means for the intervals: they are widened, or of these logs alone. Empty: there is none.
std::string intervalSentence(const Identification& identification);
/// Time from the write of a goal to the read of its row that the fit found, s. None: the case knows it, or no fit was
/// accepted and the model has the middle of a row.
std::optional<double> foundWriteTime(const Case& given, const Identification& identification);
/// The same as a sentence; empty: none.
std::string writeTimeSentence(const Case& given, const Identification& identification);
/// The effects that were tried and withdrawn, with their values; empty: none.
std::string triedSentence(const Identification& identification);

/// Share of cases in which chance exceeds the threshold: "1 %", or "at most 2.5 %" where noise alone does not explain
/// what is left.
std::string chanceShare(const Identification& identification);

/// Rivals that the data do not exclude.
std::vector<Rival> closeRivals(const Identification& identification);
/// Of `ambiguous`: the effects in which the close rivals differ from what was found, that of the model first.
std::vector<const twin::EffectInfo*> undecidedEffects(const Identification& identification);

/// "31.0", "0.931": three digits of a position error, mrad.
std::string inMrad(double rad);
/// As results.json has it: three digits behind the point; NaN stays.
double mradOf(double rad);

}  // namespace darwinop::gap
