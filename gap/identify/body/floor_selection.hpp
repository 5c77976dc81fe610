// Which effects of floor, trunk and moving sensor explain the recordings on the floor: forward selection.
#pragma once

#include <memory>

#include "gap/identify/body/floor_fit.hpp"
#include "gap/localize/body/body_table.hpp"

namespace darwinop::gap {

struct FoundFloor {
  PlacedFloor placed;
  std::vector<double> sigmas;       // of its values; 0: not fitted
  std::vector<PlacedFloor> rivals;  // that the data do not exclude, best first
};

struct FloorSelection {
  std::shared_ptr<const std::vector<FloorEffect>> effects;  // that are looked for
  std::vector<FoundFloor> found;                            // in the order in which they were found
  std::vector<BodyRow> rows, rows_after;                    // before and with what was found
  std::vector<PlacedFloor> tried;                           // nearest, but no name
};

/// What a limb does that clamped logs leave unexplained may be all there is of the effect: trunk and sensors feel the
/// reaction of the limb, whether or not its own joints are compared.
bool isOfLimb(const FloorEffect& effect, const std::vector<Joint>& unexplained);

/// `about`: the model with all that clamped logs have shown. `ignored`: joints that they leave unexplained.
/// `other_rows`: of the table, that compete for the level of significance.
FloorSelection identifyFloor(const BodyCase& given, const FloorModel& about, const std::vector<Joint>& ignored,
                             std::size_t other_rows);

/// Of the gyroscope alone, by the feet that stand: measured joints and no simulation, so that a leg may move otherwise
/// than its model. Without rows.
FloorSelection identifyMovingGyro(const BodyCase& given, const FloorModel& about);

}  // namespace darwinop::gap
