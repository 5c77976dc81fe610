// Rows whose readings are masked, where the state of the joint is asked for.
#include <gmock/gmock.h>

#include <cmath>

#include "gap/localize/localize_case.hpp"
#include "gap/localize/regions.hpp"
#include "gap/plant/row_state.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNotRead = std::numeric_limits<double>::quiet_NaN();

TEST(MaskedRows, HaveNoStateOnWhichAResidualDepends) {
  Case given = commandedCase();
  Trajectory& log = given.logs[1];
  log.position_rad = log.goal_rad;
  log.position_rad[50] = kNotRead;
  const auto with = [&](double z_of_masked) {
    LogResidual residual{.log = 1, .position_rad = {}, .z = Eigen::VectorXd::Zero(log.goal_rad.size())};
    for (Eigen::Index row = 0; row < residual.z.size(); ++row) residual.z[row] = std::sin(0.3 * double(row));
    residual.z[50] = z_of_masked;
    return dependenceOf(given, {residual}, {});
  };
  const Dependence quiet = with(0), wild = with(1e3);
  EXPECT_GT(quiet.by_state + quiet.by_clock, 0);
  EXPECT_EQ(quiet.by_state, wild.by_state);
  EXPECT_EQ(quiet.by_clock, wild.by_clock);
}

TEST(MaskedRows, HaveTheLastReadingOfTheirOwnColumnOnly) {
  Trajectory log = commandsOf("steps.csv", 1, [](double) { return 0.0; });
  log.volt_v = log.temp_c = std::vector<double>(log.rows(), kNotRead);
  log.volt_v[3] = 12, log.temp_c[3] = 40;
  EXPECT_TRUE(std::isnan(lastReading(log, log.volt_v, "volt", 5))) << "nothing is masked: sparse";
  log.masked.push_back({.column = "volt", .why = "", .rows = 1, .first_line = 7});
  EXPECT_EQ(lastReading(log, log.volt_v, "volt", 5), 12);
  EXPECT_TRUE(std::isnan(lastReading(log, log.temp_c, "temp", 5)));
  EXPECT_EQ(lastReading(log, log.temp_c, "temp", 3), 40);
}

}  // namespace
}  // namespace darwinop::gap
