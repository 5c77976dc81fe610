// Where logs and model diverge, before any fit: noise floor, block tests, intervals, dependence on the state.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gap/localize/blocks.hpp"
#include "gap/localize/intervals.hpp"
#include "gap/localize/noise_floor.hpp"
#include "gap/localize/regions.hpp"
#include "gap/localize/residual.hpp"

namespace darwinop::gap {

struct Localization {
  std::vector<std::string> files;  // of the logs, as in floor and residuals
  NoiseFloor floor;
  std::vector<LogResidual> residuals;
  Blocks blocks;
  std::vector<GapInterval> places;
  Dependence dependence;  // empty if there is no gap

  [[nodiscard]] double rms_rad() const;  // of all logs together
  [[nodiscard]] double floors() const;   // that, over the floor
};

/// Deterministic. A few seconds for ten logs.
Localization localize(const Study& study);

/// For a terminal of 100 columns, at most 25 lines.
std::string asText(const Localization& where);
nlohmann::ordered_json asJson(const Localization& where);
/// Two or three sentences on what a model leaves unexplained: how large, where and when, on what it depends.
std::string describeRemainder(const Localization& where);

}  // namespace darwinop::gap
