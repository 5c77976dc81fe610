// The gap on held-out recordings, for a terminal and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gap/identify/body/held_out_gap.hpp"

namespace darwinop::gap {

/// A line about the groups of signals that held-out logs have; empty: there are none.
std::string asText(const HeldOutGap& gap);
/// `gap_score_before`, `gap_score_after` or `floor` of an answer; null: not known.
nlohmann::ordered_json asJson(const GapErrors& of);

}  // namespace darwinop::gap
