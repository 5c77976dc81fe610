// Which effects of joints and links explain what the clamped limbs show: forward selection, best of all names.
#pragma once

#include "gap/identify/body/mechanics_fit.hpp"
#include "gap/localize/body/body_table.hpp"

namespace darwinop::gap {

struct FoundMechanics {
  PlacedMechanics placed;
  std::vector<double> sigmas;           // of its values; 0: not fitted
  std::vector<PlacedMechanics> rivals;  // that the data do not exclude, best first
  double gain = 0;                      // of the cost, by this effect
  double excess_before = 0;             // beyond noise in its limbs when it was added
  std::vector<double> own = {};         // of an addition: each of its joints' number without it
  bool is_in_controller = false;        // found in the loads alone, whatever else is wrong in its limbs
};

struct MechanicsSelection {
  std::vector<FoundMechanics> found;   // in the order in which they were found
  std::vector<BodyRow> rows;           // of the table, with what was found; those that remain are open
  std::vector<Joint> touched;          // joints of the limbs that a found effect is in
  std::vector<PlacedMechanics> tried;  // earned its place, but a log contradicts it, or it left too much unexplained
};

/// Names that an effect at its places competes with count: twice the logarithm of their number is the price of one.
double namePrice(const PlacedMechanics& placed);

/// `robot`: its noise is estimated again about what is found.
MechanicsSelection identifyMechanics(ClampedRobot& robot, const BodyTable& table);

}  // namespace darwinop::gap
