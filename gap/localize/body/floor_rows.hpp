// Rows of the table from recordings of a robot on the floor.
#pragma once

#include "gap/localize/body/body_table.hpp"
#include "gap/localize/body/floor_residuals.hpp"

namespace darwinop::gap {

/// A row for each signal, at the place "floor", which includes the trunk.
std::vector<BodyRow> floorRows(const BodyCase& given, const FloorResiduals& residuals, const FloorTraces& traces,
                               const ImuDeviation& imu);

/// The table with the signals on the floor, about the model of `robot`; unchanged without such a log. Simulates for
/// some seconds.
BodyTable withFloor(BodyTable table, const ClampedRobot& robot);

}  // namespace darwinop::gap
