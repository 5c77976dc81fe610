// Where simulation and measurement disagree, before anything is fitted. docs/gap/where.md says how to read it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gap/locate/blocks.hpp"
#include "gap/locate/floor.hpp"
#include "gap/locate/places.hpp"
#include "gap/locate/regions.hpp"
#include "gap/locate/residual.hpp"

namespace darwinop::gap {

struct Where {
  std::vector<std::string> files;  // of the logs, as in floor and residuals
  NoiseFloor floor;
  std::vector<LogResidual> residuals;
  Blocks blocks;
  std::vector<Place> places;
  Dependence dependence;  // of nothing where there is no gap

  [[nodiscard]] double rms_rad() const;  // of all logs together
  [[nodiscard]] double floors() const;   // that, over the floor
};

/// `evidence`: of the baseline (evidenceOf()). Deterministic. A few seconds for ten logs.
Where locate(const Case& given, const Evidence& evidence);

/// For a terminal of 100 columns, at most 25 lines.
std::string asText(const Where& where);
nlohmann::ordered_json asJson(const Where& where);
/// Of what a model leaves unexplained, in two or three sentences: how big, where and when, on what it depends.
std::string whatRemains(const Where& where);

}  // namespace darwinop::gap
