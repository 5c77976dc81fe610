// Prints what the judges of a campaign tolerated.
#include "campaign/leniencies.hpp"

#include <cstdio>

namespace darwinop {

std::string nameOf(const LeniencyRow& row) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%g", row.bound);
  return std::string{row.name} + " (" + number.data() + " " + std::string{row.unit} + ")";
}

std::string report(const Tolerated& tolerated) {
  std::string text = "tolerated:\n";
  for (const LeniencyRow& row : kLeniencyTable) {
    std::array<char, 32> count{};
    std::snprintf(count.data(), count.size(), "%10ld  ", tolerated.of(row.leniency));
    text += count.data() + nameOf(row) + ": " + std::string{row.why} + "\n";
  }
  return text;
}

}  // namespace darwinop
