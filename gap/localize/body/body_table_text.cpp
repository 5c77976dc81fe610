// The table for a terminal and for programs.
#include <algorithm>

#include "core/text/formatted.hpp"
#include "gap/localize/body/body_table.hpp"

namespace darwinop::gap {
namespace {

std::string lineOf(const BodyRow& row) {
  return text::formatted("  %-18s %-14s %-11s %8.1f %10.4g %-6s %6.1f  %s %.2f to %.2f s\n", row.signal.c_str(),
                         row.place.name.c_str(), std::string{name(row.block)}.c_str(), row.floors, row.size,
                         row.unit.c_str(), row.significance, row.file.c_str(), row.t0_s, row.t1_s);
}

/// "controller: 18 closed, at most 0.2 floors"
std::string closedLine(const BodyTable& table, Block block) {
  std::size_t closed = 0;
  double greatest = 0;
  for (const BodyRow& row : table.rows)
    if (row.block == block && !row.open) ++closed, greatest = std::max(greatest, row.floors);
  return closed == 0 ? ""
                     : text::formatted("  %s: %zu closed, at most %.1f floors\n", std::string{name(block)}.c_str(),
                                       closed, greatest);
}

}  // namespace

std::string asText(const BodyTable& table) {
  std::string out = text::formatted("%zu signals tested, %zu beyond %.1f sigma: by chance one is in 1 %% of cases\n",
                                    table.rows.size(), table.open(), table.open_from);
  if (table.open() > 0)
    out += text::formatted("  %-18s %-14s %-11s %8s %10s %-6s %6s  %s\n", "signal", "place", "block", "floors", "size",
                           "", "sigma", "largest in");
  for (const BodyRow& row : table.rows)
    if (row.open) out += lineOf(row);
  for (const Block block : {Block::kController, Block::kSupply, Block::kPlant, Block::kSensor})
    out += closedLine(table, block);
  out += "Not tested:\n";
  for (const std::string& sentence : table.not_tested) out += "  " + sentence + "\n";
  return out;
}

nlohmann::ordered_json asJson(const BodyTable& table) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const BodyRow& row : table.rows)
    rows.push_back({{"signal", row.signal},
                    {"at", row.place.name},
                    {"block", name(row.block)},
                    {"open", row.open},
                    {"floors", row.floors},
                    {"size", row.size},
                    {"unit", row.unit},
                    {"significance", row.significance},
                    {"file", row.file},
                    {"t0", row.t0_s},
                    {"t1", row.t1_s}});
  return {{"open_from", table.open_from}, {"rows", rows}, {"not_tested", table.not_tested}};
}

}  // namespace darwinop::gap
