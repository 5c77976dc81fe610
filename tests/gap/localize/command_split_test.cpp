// What a command or a controller explains of a residual that both could cause.
#include "gap/localize/command_split.hpp"

#include <gtest/gtest.h>

#include "gap/localize/localize_case.hpp"

namespace darwinop::gap {
namespace {

constexpr double kWrong = 5;  // sigmas

/// A residual in every row: `changed` once the hypothesis has any effect more than the case.
struct Cut {
  const Case& given;
  std::function<double(const Trajectory&, std::size_t)> as_given;
  double changed;

  BlockResiduals operator()(const Trajectory& log, const Hypothesis& hypothesis) const {
    const auto rows = static_cast<Eigen::Index>(log.rows());
    BlockResiduals out{Eigen::VectorXd::Zero(rows), Eigen::VectorXd::Ones(rows), Eigen::VectorXd::Zero(rows), {}};
    const bool same = hypothesis.effects.size() == given.model.effects.size();
    for (std::size_t row = 0; row < log.rows(); ++row) {
      out.row.push_back(row);
      out.residual[static_cast<Eigen::Index>(row)] = same ? as_given(log, row) : changed;
    }
    out.z = out.residual;
    return out;
  }
};

CommandSplit splitOf(const Case& given, const Cut& cut, double expected_cost) {
  const std::vector<std::size_t> logs{0, 1, 2};
  BlockTest judged;
  for (const std::size_t i : logs) judged.samples.push_back(cut(given.logs[i], baselineOf(given)));
  judged.expected_cost = expected_cost;
  return splitCommand(cut, given, logs, judged, baselineOf(given));
}

double everywhere(const Trajectory& /*log*/, std::size_t /*row*/) {
  return kWrong;
}

TEST(CommandSplit, ExplainsAtMostAll) {
  const Case given = measuredCase({});
  const auto rows = static_cast<double>(given.logs[0].rows() + given.logs[1].rows() + given.logs[2].rows());
  const CommandSplit split = splitOf(given, {given, &everywhere, 0}, 10 * rows);
  EXPECT_EQ(split.by_command.share, 1) << "less than noise is left";
  EXPECT_EQ(split.by_controller.share, 1);
}

// The goal of a sweep hardly rests: a residual that is the same everywhere is as large there as elsewhere.
TEST(CommandSplit, ADeadZoneInSweepsIsNotACommand) {
  const Case given = measuredCase({});
  const CommandSplit same = splitOf(given, {given, &everywhere, kWrong}, 0);
  EXPECT_NEAR(same.at_rest, 1, 0.01);
  EXPECT_FALSE(same.isCommand());
  const auto in_motion = [](const Trajectory& log, std::size_t row) {
    const std::size_t before = row < 31 ? 0 : row - 31;
    return log.goal_rad[row] == log.goal_rad[before] ? 0.0 : kWrong;
  };
  const CommandSplit slow = splitOf(given, {given, in_motion, kWrong}, 0);
  EXPECT_TRUE(slow.isCommand()) << "nothing is left where the goal rests: " << slow.at_rest;
}

}  // namespace
}  // namespace darwinop::gap
