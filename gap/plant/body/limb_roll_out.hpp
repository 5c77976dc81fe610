// Simulates one limb of a robot with a clamped trunk: its servos follow the recorded goals.
#pragma once

#include <vector>

#include "gap/case/body/body_case.hpp"
#include "gap/plant/body/limb.hpp"
#include "gap/plant/hypothesis.hpp"
#include "gap/plant/trace.hpp"

namespace darwinop::gap {

/// What a hypothesis changes in one link.
struct LinkChange {
  Joint link{};        // that this joint moves
  double mass_kg = 0;  // added, at this distance from the centre of mass
  Eigen::Vector3d from_com_m = Eigen::Vector3d::Zero(), com_shift_m = Eigen::Vector3d::Zero();  // in the link's frame
};

struct BodyHypothesis {
  Hypothesis servos;  // an effect of one joint has that joint as its place
  std::vector<LinkChange> links;
  bool has_board_supply = false;  // the servos have the measured voltage of the board, not that of a rested battery
};

/// The model of a case. Where its battery has a resistance, the servos have the measured voltage of the board.
BodyHypothesis declaredRobot(const BodyCase& given);

/// V, of the servos from this row on.
double supplyAt(const BodyLog& log, std::size_t row, const BodyHypothesis& hypothesis);

/// All its joints answer.
bool isRecorded(const BodyCase& given, const Limb& limb);

/// Of each row, the encoder's position and the duty in the last firmware cycle before it. rows x joints of the limb.
struct LimbTrace {
  Eigen::MatrixXd position_rad, duty;
};

/// Law voltage_p only. NaN from where the simulation has left its range. Deterministic.
/// `noise`: as that of a bench, other for each joint.
LimbTrace rollOut(const BodyCase& given, std::size_t log, const Limb& limb, const BodyHypothesis& hypothesis,
                  const Disturbance* noise = nullptr);

}  // namespace darwinop::gap
