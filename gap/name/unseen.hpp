// Whether an effect also helps where it was not fitted: each log in turn is left out of the fit and foretold.
#pragma once

#include <vector>

#include "gap/name/settled.hpp"

namespace darwinop::gap {

/// By what factor `with` foretells a log that it has not seen better than `without` does: mean of its logarithm over
/// the logs, and the standard error of that mean.
struct Foretold {
  double mean = 0, error = 0;
  int logs = 0;

  /// By more than two standard errors.
  [[nodiscard]] bool better() const { return logs > 2 && mean > 2 * error; }
};
Foretold foretold(const Settled& without, const Settled& with);

/// Mean |position error| of each log when the others alone are fitted, rad; and the comparison of two such lists.
std::vector<double> errorsUnseen(const Settled& fitted);
Foretold foretold(const std::vector<double>& without, const std::vector<double>& with);

}  // namespace darwinop::gap
