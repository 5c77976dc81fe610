// The outcome of an investigation as text, as results.json, and as edits of a model file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gap/report/addition.hpp"
#include "gap/report/comparison.hpp"
#include "gap/workflow.hpp"

namespace darwinop::gap {

/// For a terminal: place, effect, interval, error before and after; at most 24 lines of 100 columns.
std::string asText(const Case& given, const Outcome& outcome, const Comparison& comparison);
std::string asText(const Case& given, const Outcome& outcome);
/// Of two models, where nothing was searched.
std::string asText(const Case& given, const Comparison& comparison);
/// Version of the keys in results.json and report.json. 1 (without the key `format`): doubted, strained, opens,
/// remains, score. Readers accept both.
inline constexpr int kResultsFormat = 2;
/// For programs: one object a case, docs/gap/report.md. `gap_score_*` keep their names: other programs read them.
nlohmann::json asJson(const Case& given, const Outcome& outcome);
/// Of a case that could not be used.
nlohmann::json badInput(const std::string& name, const std::string& why);

/// The findings as additions to a model file; `data_hash` goes into its comments.
Additions additionsOf(const Case& given, const Outcome& outcome, const std::string& data_hash);
/// The case's model as a model file.
std::string caseModel(const Case& given);

}  // namespace darwinop::gap
