// Which logs of a large folder are searched.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "core/units.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/raw_folder.hpp"

namespace darwinop::gap {
namespace {

constexpr double kDuration = 6;  // s

struct Motion {
  const char* kind;
  double (*goal_rad)(double s);
  double released_from_s;
};

/// From 0 to `to` in a time, with speed 0 at both ends.
double smoothed(double share, double to) {
  const double s = std::min(1.0, share);
  return to * s * s * (3 - 2 * s);
}

// The motions that BAM records.
constexpr Motion kMotions[] = {
    {"lift_and_drop", [](double s) { return smoothed(s / 2, -kPi / 2); }, 2},
    {"sin_sin", [](double s) { return kPi / 2 * (std::sin(s) + std::sin(5 * s) * std::sin(2 * s)); }, kDuration},
    {"sin_time_square", [](double s) { return std::sin(s * s); }, kDuration},
    {"up_and_down", [](double s) { return s < 3 ? smoothed(s / 3, kPi / 2) : smoothed(2 - s / 3, kPi / 2); },
     kDuration}};

Trajectory logOf(const Motion& motion, double kp, double payload_kg, double length_m) {
  Trajectory log;
  log.kind = motion.kind;
  log.p_register = kp, log.payload_kg = payload_kg, log.length_m = length_m;
  for (double s = 0; s < kDuration; s += 0.0055) {
    log.time_s.push_back(s);
    log.goal_rad.push_back(motion.goal_rad(s));
    log.torque_on.push_back(s < motion.released_from_s ? 1 : 0);
  }
  return log;
}

/// The logs of a folder in the order of names that begin with the motion, or with the gain.
FolderCase everyBench(bool by_motion) {
  FolderCase out;
  for (const double kp : {4, 8, 16, 32})
    for (const double payload_kg : {0.5, 1.0, 1.5, 2.0})
      for (const double length_m : {0.1, 0.15, 0.2})
        for (const Motion& motion : kMotions) out.given.logs.push_back(logOf(motion, kp, payload_kg, length_m));
  if (by_motion) std::ranges::stable_sort(out.given.logs, {}, &Trajectory::kind);
  holdOut({}, out);
  return out;
}

TEST(ChooseLogs, EachMotionIsFittedAndHeldOut) {
  for (const bool by_motion : {true, false}) {
    FolderCase in = everyBench(by_motion);
    chooseLogs(in);
    std::map<std::string, std::size_t> fitted, held_out;
    std::map<double, std::size_t> gains, payloads;  // of the fitted
    for (const Trajectory& log : in.given.logs) {
      ++(log.held_out ? held_out : fitted)[log.kind];
      if (!log.held_out) ++gains[log.p_register], ++payloads[log.payload_kg];
    }
    for (const double kp : {4, 8, 16}) EXPECT_GE(gains[kp], 3u);
    for (const double payload_kg : {0.5, 1.0, 1.5, 2.0}) EXPECT_GE(payloads[payload_kg], 2u);
    for (const Motion& motion : kMotions) {
      EXPECT_GE(fitted[motion.kind], 2u) << motion.kind;
      EXPECT_GE(held_out[motion.kind], 1u) << motion.kind;
    }
  }
}

// Of a servo whose load was read, a log without it distinguishes no effect of the firmware.
TEST(ChooseLogs, ThoseThatShowLessComeLast) {
  FolderCase in = everyBench(true);
  for (std::size_t i = 0; i < in.given.logs.size(); ++i) {
    Trajectory& log = in.given.logs[i];
    log.load.assign(log.rows(), i % 5 == 0 ? std::nan("") : 0.1);
    if (i % 5 != 1) continue;
    for (auto* const column : {&log.time_s, &log.goal_rad, &log.load}) column->resize(log.rows() / 3);
    log.torque_on.resize(log.time_s.size());
  }
  chooseLogs(in);
  for (const Trajectory& log : in.given.logs) {
    EXPECT_FALSE(std::isnan(log.load.front()));
    EXPECT_GT(log.duration_s(), kDuration / 2);
  }
  for (Trajectory& log : in.given.others) log.load.assign(log.rows(), std::nan(""));
  FolderCase poor;
  poor.given.logs = in.given.others;
  chooseLogs(poor);
  EXPECT_GT(poor.given.logs.size(), 12U) << "there is nothing better";
}

// The time of a search grows with the seconds of its logs.
TEST(ChooseLogs, OfLongLogsFewerAreTaken) {
  FolderCase in = everyBench(true);
  for (Trajectory& log : in.given.logs)
    for (double& time_s : log.time_s) time_s *= 5;
  chooseLogs(in);
  const auto held_out = std::ranges::count_if(in.given.logs, &Trajectory::held_out);
  EXPECT_EQ(held_out, 2);
  EXPECT_EQ(std::ssize(in.given.logs) - held_out, 4);
  EXPECT_THAT(in.notes.back(), testing::Not(testing::HasSubstr("--all-logs")));
}

TEST(ChooseLogs, ASearchOfAllOfManyLogsIsWarnedOf) {
  FolderCase in = everyBench(true);
  noteAllLogs(in);
  EXPECT_THAT(in.notes.back(), testing::HasSubstr(messages::kManyLogs));
}

}  // namespace
}  // namespace darwinop::gap
