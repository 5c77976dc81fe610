// Repeats of a released joint that come to rest in different places.
#pragma once

#include <Eigen/Core>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Deviations of the runs that repeat each other from their mean, a column a run, rad; scaled so that the mean of their
/// outer products is the variance of one run. Zero up to where the runs part. No column, unless they all come to rest
/// with torque off, at one temperature, further apart than `rest_sigma_rad` explains: what decides where such a run
/// comes to rest is below what any model knows.
Eigen::MatrixXd bifurcationOf(const Case& given, std::size_t log, double rest_sigma_rad);

}  // namespace darwinop::gap
