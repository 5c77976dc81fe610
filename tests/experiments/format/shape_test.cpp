// Goals at times: each shape against values that can be worked out by hand.
#include "experiments/format/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace darwinop::experiments {
namespace {

constexpr double kExact = 1e-12;  // rounding of a handful of operations

Goal goal(Shape shape) {
  Goal out;
  out.shape = shape;
  out.to = 0.8;
  out.amplitude = 0.5;
  out.period_s = 4;
  out.hz = {0.25};
  return out;
}

/// Of a phase of 10 s that begins at 0.2 rad.
double at(const Goal& goal, double t, double sign = 1) {
  return goalAt(goal, 10, sign, 0.2, t);
}

TEST(Shape, HoldStaysAndStepJumps) {
  EXPECT_EQ(at(goal(Shape::kHold), 7), 0.2);
  EXPECT_NEAR(at(goal(Shape::kStep), 0), 0.8, kExact);
  EXPECT_NEAR(at(goal(Shape::kStep), 0, -1), -0.8, kExact) << "mirrored";
}

TEST(Shape, RampIsALineAndMoveRestsAtBothEnds) {
  EXPECT_NEAR(at(goal(Shape::kRamp), 2.5), 0.35, kExact);
  EXPECT_NEAR(at(goal(Shape::kRamp), 99), 0.8, kExact) << "stays at its end";
  EXPECT_NEAR(at(goal(Shape::kMove), 5), 0.5, kExact) << "half way at half time";
  EXPECT_NEAR(at(goal(Shape::kMove), 10), 0.8, kExact);
  EXPECT_NEAR(at(goal(Shape::kMove), 0.1), 0.2, 1e-5) << "10 (t/T)^3 of 0.6 rad is 6e-6 rad";
  EXPECT_NEAR((smooth(0.501) - smooth(0.499)) / 0.002, kSteepest, 1e-4) << "the steepest place, its curvature left out";
}

TEST(Shape, StepsTakeOneTimeForAllOrOneEach) {
  Goal steps = goal(Shape::kSteps);
  steps.goals = {0.1, 0.2, 0.3};
  steps.every_s = {2};
  EXPECT_EQ(at(steps, 1.9), 0.1);
  EXPECT_EQ(at(steps, 2.0), 0.2);
  EXPECT_EQ(at(steps, 9.0), 0.3) << "the last one stays";
  steps.every_s = {1, 3, 1};
  EXPECT_EQ(at(steps, 3.9), 0.2);
  EXPECT_EQ(at(steps, 4.0), 0.3);
  EXPECT_EQ(at(steps, 4.0, -1), -0.3);
}

TEST(Shape, SwingsBeginWhereThePhaseBegins) {
  Goal any = goal(Shape::kTriangle);
  any.hz = {0.5, 2};
  for (const Shape shape : {Shape::kTriangle, Shape::kSine, Shape::kChirp, Shape::kMultisine}) {
    any.shape = shape;
    EXPECT_NEAR(at(any, 0), 0.2, kExact) << static_cast<int>(shape);
  }
}

TEST(Shape, TriangleGoesUpFirst) {
  EXPECT_NEAR(at(goal(Shape::kTriangle), 1), 0.7, kExact);
  EXPECT_NEAR(at(goal(Shape::kTriangle), 2), 0.2, kExact);
  EXPECT_NEAR(at(goal(Shape::kTriangle), 3), -0.3, kExact);
  EXPECT_NEAR(at(goal(Shape::kTriangle), 5), 0.7, kExact) << "a period later";
}

TEST(Shape, SineHasItsPeakAfterAQuarterPeriod) {
  EXPECT_NEAR(at(goal(Shape::kSine), 1), 0.7, kExact);
  EXPECT_NEAR(at(goal(Shape::kSine), 1, -1), -0.3, kExact);
}

TEST(Shape, ChirpEndsAtItsSecondFrequency) {
  Goal chirp = goal(Shape::kChirp);
  chirp.hz = {0.2, 2};
  // In the middle of 10 s it has made (0.2 + 1.1) / 2 * 5 = 3.25 turns: at its peak.
  EXPECT_NEAR(at(chirp, 5), 0.7, kExact);
  // Near the end, zeros of the sine are half a period of 2 Hz apart, 0.25 s; the frequency changes by 2 % meanwhile.
  int zeros = 0;
  for (double t = 9; t < 10 - 1e-9; t += 0.001)
    zeros += (at(chirp, t) - 0.2) * (at(chirp, t + 0.001) - 0.2) < 0 ? 1 : 0;
  EXPECT_NEAR(zeros, 4, 1) << "2 Hz: four crossings a second, a bit less before the end";
}

TEST(Shape, MultisineStaysWithinItsAmplitude) {
  Goal many = goal(Shape::kMultisine);
  many.hz = {0.25, 0.5, 1.5};
  // After 1 s the three have made a quarter, a half and one and a half turns: +1, 0 and 0 of three equal shares.
  EXPECT_NEAR(at(many, 1), 0.2 + 0.5 / 3, kExact);
  // After half a second: an eighth, a quarter downwards, three quarters.
  EXPECT_NEAR(at(many, 0.5), 0.2 + 0.5 / 3 * (std::numbers::sqrt2 / 2 - 1 - 1), kExact);
  double most = 0;
  for (double t = 0; t < 10; t += 0.01) most = std::max(most, std::abs(at(many, t) - 0.2));
  EXPECT_LE(most, 0.5 + kExact);
  EXPECT_GE(most, 0.25) << "and uses a good part of it";
}

}  // namespace
}  // namespace darwinop::experiments
