// A standard error that is estimated from a few logs: its intervals are wider than those of a normal distribution.
#pragma once

namespace darwinop::gap {

/// Standard errors within which a mean of `logs` values, at least two, is with a chance of 90 % on both sides
/// (Student's t): 2.9 for three logs, 1.8 for twelve, 1.645 for very many.
double interval90(int logs);

}  // namespace darwinop::gap
