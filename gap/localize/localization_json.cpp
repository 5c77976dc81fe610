#include <cmath>

#include "gap/localize/localization.hpp"

namespace darwinop::gap {
namespace {

using Object = nlohmann::ordered_json;

/// What is not known is null.
Object known(double value) {
  return std::isfinite(value) ? Object(value) : Object(nullptr);
}

Object ofLogs(const Localization& where) {
  Object logs = Object::array();
  for (std::size_t i = 0; i < where.files.size(); ++i) {
    const LogFloor& floor = where.floor.logs[i];
    logs.push_back({{"file", where.files[i]},
                    {"gap_mrad", 1e3 * where.residuals[i].rms_rad},
                    {"gap_floors", where.residuals[i].floors},
                    {"floor_mrad", 1e3 * floor.rms_rad},
                    {"quantisation_mrad", 1e3 * floor.quantisation_rad},
                    {"bifurcates", floor.bifurcates},
                    {"repeats_mrad", known(1e3 * floor.repeats_rad)},
                    {"repeats_expected_mrad", known(1e3 * floor.expected_rad)}});
  }
  return logs;
}

Object ofBlocks(const Blocks& blocks) {
  Object all = Object::array();
  for (const BlockFinding& block : blocks.all)
    all.push_back({{"block", name(block.block)},
                   {"verdict", name(block.verdict)},
                   {"rms", known(block.rms)},
                   {"expected_rms", known(block.expected_rms)},
                   {"unit", block.unit},
                   {"significance", block.significance},
                   {"numbers_moved_sigma", block.moved},
                   {"effect_mrad", 1e3 * block.effect_rad},
                   {"share", block.share},
                   {"detail", block.detail}});
  return all;
}

Object ofPlaces(const std::vector<GapInterval>& places) {
  Object all = Object::array();
  for (const GapInterval& place : places)
    all.push_back({{"signal", place.signal},
                   {"joint", place.joint},
                   {"file", place.file},
                   {"t0", place.t0_s},
                   {"t1", place.t1_s},
                   {"happens", place.happens},
                   {"block", place.block ? Object(name(*place.block)) : Object(nullptr)},
                   {"chi2", place.chi2},
                   {"samples", place.samples},
                   {"size", place.size},
                   {"unit", place.unit}});
  return all;
}

Object ofDependence(const Dependence& dependence) {
  Object regions = Object::array();
  for (const Region& region : dependence.regions)
    regions.push_back({{"variable", region.variable},
                       {"unit", region.unit},
                       {"information_bits", region.information},
                       {"low", region.low},
                       {"high", region.high},
                       {"lift", region.lift}});
  return {{"of", dependence.of},
          {"on", name(dependence.on)},
          {"by_state", dependence.by_state},
          {"by_clock", dependence.by_clock},
          {"regions", regions}};
}

}  // namespace

nlohmann::ordered_json asJson(const Localization& where) {
  const Blocks& blocks = where.blocks;
  return {{"gap_mrad", 1e3 * where.rms_rad()},
          {"gap_floors", where.floors()},
          {"floor_assumed", where.floor.assumed},
          {"repeats_mrad", known(1e3 * where.floor.repeats_rad)},
          {"repeats_over_assumed", where.floor.assumed ? Object(nullptr) : Object(where.floor.factor)},
          {"first_block", blocks.first ? Object(name(*blocks.first)) : Object(nullptr)},
          {"supply_ohm", known(blocks.supply_ohm)},
          {"supply_ohm_sigma", known(blocks.supply_ohm_sigma)},
          {"blocks", ofBlocks(blocks)},
          {"places", ofPlaces(where.places)},
          {"dependence", ofDependence(where.dependence)},
          {"logs", ofLogs(where)}};
}

}  // namespace darwinop::gap
