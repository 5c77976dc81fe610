// All that a run of `darwinop gap` found, in the forms in which people and programs read it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gap/locate/where.hpp"
#include "gap/name/naming.hpp"
#include "gap/report/addition.hpp"
#include "gap/report/comparison.hpp"

namespace darwinop::gap {

struct Outcome {
  Where where;
  Naming naming;
  // Rms position error of the closed loop on logs that no fit has seen, rad; NaN: the case has none.
  double score_before_rad = 0, score_after_rad = 0;
  std::string remains;  // for `unknown`, and `named` with a remainder: what is left, where, when and on what it
                        // depends, in sentences
  double runtime_s = 0;
};

/// Where, what, and how much it helps on the logs that were kept.
Outcome investigate(const Case& given, const NameOptions& options = {});

/// For a terminal: where, what, how sure, before and after; at most 24 lines of 100 columns.
std::string asText(const Case& given, const Outcome& outcome, const Comparison& comparison);
std::string asText(const Case& given, const Outcome& outcome);
/// Of two models, where nothing was searched.
std::string asText(const Case& given, const Comparison& comparison);
/// For programs: one object a case, docs/gap/report.md.
nlohmann::json asJson(const Case& given, const Outcome& outcome);
/// Of a case that could not be used.
nlohmann::json badInput(const std::string& name, const std::string& why);

/// What was found, as it goes into a model file; `data_hash` goes into its comments.
Additions additionsOf(const Case& given, const Outcome& outcome, const std::string& data_hash);
/// The case's model as a model file, with what was found: the twin reads it. Comments above each effect say where it
/// comes from and how sure it is.
std::string repairedModel(const Case& given, const Outcome& outcome);
/// The case's model as a model file.
std::string caseModel(const Case& given);

}  // namespace darwinop::gap
