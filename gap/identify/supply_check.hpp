// Consistency of a fitted supply sag with the measured voltage.
#pragma once

#include "gap/identify/fitted_model.hpp"

namespace darwinop::gap {

/// True: the fitted supply sag is far larger than the measured voltage drop under load. A single reading falls between
/// two pulses of the bridge and scatters, so only the slope over whole logs counts, and only when the logs agree on it.
bool contradictsVoltage(const FittedModel& fitted);

}  // namespace darwinop::gap
