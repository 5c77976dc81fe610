// Whether the voltage that the servo measured allows what a fit says about its supply.
#pragma once

#include "gap/name/settled.hpp"

namespace darwinop::gap {

/// True: the fit has a supply that gives way by far more than the measured voltage dips under load. Single readings are
/// taken between two pulses of the bridge and jump about, so that only the slope over whole logs counts, and only when
/// the logs agree on it.
bool contradictsVoltage(const Case& given, const Settled& fitted);

}  // namespace darwinop::gap
