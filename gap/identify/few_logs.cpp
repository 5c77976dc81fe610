#include "gap/identify/few_logs.hpp"

#include <boost/math/distributions/students_t.hpp>

namespace darwinop::gap {

double interval90(int logs) {
  return boost::math::quantile(boost::math::students_t{logs - 1.0}, 0.95);
}

}  // namespace darwinop::gap
